#include "image/judge.h"

#include "base/error.h"
#include "base/files.h"
#include "measure/comparison_page.h"
#include "measure/image_compare.h"

#include <algorithm>
#include <set>

namespace tarn::imagetest {

namespace {

bool isThere(const std::filesystem::path& file) { return std::filesystem::exists(file); }

std::optional<std::string> embedded(const std::filesystem::path& file)
{
    if (!isThere(file)) return std::nullopt;
    return embeddedPng(readFile(file));
}

/// The difference, where there are two pictures of one size.
std::optional<std::string> difference(const CaseFiles& files)
{
    if (!isThere(files.golden) || !isThere(files.actual)) return std::nullopt;
    const Image golden = readImage(files.golden), actual = readImage(files.actual);
    if (!comparePictures(golden, actual).mismatch.empty()) return std::nullopt;
    const std::filesystem::path file = files.actual.parent_path() / (files.actual.stem().string() + ".difference.png");
    writeImage(file, differencePicture(golden, actual));
    return embedded(file);
}

} // namespace

Verdict judge(const Case& test)
{
    const CaseFiles files = filesOf(test.name);
    if (!isThere(files.actual))
        return {false, isThere(files.problem) ? readFile(files.problem) : "the picture was not rendered"};
    if (!isThere(files.golden))
        return {false, fmt::format("{} is missing; look at the picture, then tools/golden bless {}",
                                   files.golden.string(), test.name)};
    const PictureComparison comparison = comparePictures(readImage(files.golden), readImage(files.actual));
    return {comparison.same(), comparison.summary()};
}

void writePage(const std::filesystem::path& file, const std::string& title, const std::vector<Case>& cases)
{
    std::vector<ComparisonEntry> entries;
    for (const Case& test : cases) {
        const CaseFiles files = filesOf(test.name);
        entries.push_back({test.name, test.what, judge(test).text, embedded(files.golden), embedded(files.actual),
                           difference(files)});
    }
    writeFile(file, comparisonPage(title, entries));
}

std::vector<std::string> problemsOfGoldens(const std::vector<Case>& cases)
{
    std::vector<std::string> problems;
    std::vector<Image> goldens;
    std::set<std::filesystem::path> known;
    for (const Case& test : cases) {
        const std::filesystem::path file = filesOf(test.name).golden;
        known.insert(file.filename());
        if (isThere(file)) goldens.push_back(readImage(file));
    }
    for (std::size_t i = 0; i < goldens.size(); ++i)
        for (std::size_t j = i + 1; j < goldens.size(); ++j)
            if (comparePictures(goldens[i], goldens[j]).same())
                problems.push_back(fmt::format("{} and {} pass for each other: one of the cases shows nothing",
                                               goldens[i].name, goldens[j].name));
    for (const auto& entry : std::filesystem::directory_iterator(goldenFolder()))
        if (!known.contains(entry.path().filename()))
            problems.push_back(fmt::format("{} belongs to no case; remove it", entry.path().string()));
    return problems;
}

void bless(const Case& test)
{
    const CaseFiles files = filesOf(test.name);
    if (!isThere(files.actual)) throw Error("{}: {}", test.name, judge(test).text);
    std::filesystem::create_directories(goldenFolder());
    writeFile(files.golden, readFile(files.actual));
}

} // namespace tarn::imagetest
