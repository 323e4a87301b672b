// The picture tests' program. CTest calls `render` once per group, then `check` once per case, and `lossless` once per
// group; people call `review` and `bless` through tools/golden. image_tests draws through OSMesa, image_tests_egl
// through EGL.
#include "base/error.h"
#include "image/judge.h"
#include "image/lossless.h"
#include "image/render_group.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>

namespace tarn::imagetest {

namespace {

std::vector<Case> allCases(const std::vector<Group>& groups)
{
    std::vector<Case> cases;
    for (const Group& group : groups) cases.insert(cases.end(), group.cases.begin(), group.cases.end());
    return cases;
}

/// Cases whose name holds the text; all of them for "". Throws UsageError when there is none.
std::vector<Case> matching(const std::vector<Group>& groups, const std::string& text)
{
    std::vector<Case> cases = allCases(groups);
    std::erase_if(cases, [&](const Case& test) { return test.name.find(text) == std::string::npos; });
    if (cases.empty()) throw UsageError("no case has '{}' in its name", text);
    return cases;
}

int render(const std::vector<Group>& groups, const std::string& name)
{
    bool any = false;
    for (const Group& group : groups)
        if (name.empty() || group.name == name) {
            renderGroup(group);
            any = true;
        }
    if (!any) throw UsageError("no group is named '{}'", name);
    return 0;
}

int lossless(const std::vector<Group>& groups, const std::string& name)
{
    int failures = 0;
    bool any = false;
    for (const Group& group : groups)
        if (name.empty() || group.name == name) {
            failures += checkLossless(group);
            any = true;
        }
    if (!any) throw UsageError("no group is named '{}'", name);
    return failures == 0 ? 0 : 1;
}

int check(const std::vector<Group>& groups, const std::string& name)
{
    const std::vector<Case> cases = allCases(groups);
    const auto test = std::find_if(cases.begin(), cases.end(), [&](const Case& c) { return c.name == name; });
    if (test == cases.end()) throw UsageError("no case is named '{}'", name);
    const std::filesystem::path page = filesOf(name).page;
    std::filesystem::remove(page);
    const Verdict verdict = judge(*test);
    fmt::print("{}: {}\n", name, verdict.text);
    if (verdict.good) return 0;
    writePage(page, name, {*test});
    fmt::print("{}\nexpected, actual and difference: {}\n", test->what, page.string());
    return 1;
}

/// Renders a group and checks its cases: all in one, for a second way to a context with the same goldens.
int verify(const std::vector<Group>& groups, const std::string& name)
{
    render(groups, name);
    int failures = 0;
    for (const Group& group : groups) {
        if (!name.empty() && group.name != name) continue;
        for (const Case& test : group.cases) failures += check(groups, test.name);
    }
    return failures == 0 ? 0 : 1;
}

int checkGoldens(const std::vector<Group>& groups)
{
    const std::vector<std::string> problems = problemsOfGoldens(allCases(groups));
    for (const std::string& problem : problems) fmt::print("{}\n", problem);
    return problems.empty() ? 0 : 1;
}

/// One page of the cases that fail, among those that match.
int review(const std::vector<Group>& groups, const std::string& pattern)
{
    std::vector<Case> cases = matching(groups, pattern);
    std::erase_if(cases, [](const Case& test) { return judge(test).good; });
    if (cases.empty()) {
        fmt::print("every picture is as its golden\n");
        return 0;
    }
    const std::filesystem::path page = resultFolder() / "review.html";
    writePage(page, fmt::format("{} pictures are not as their goldens", cases.size()), cases);
    fmt::print("{}\n", page.string());
    return 0;
}

int blessMatching(const std::vector<Group>& groups, const std::string& pattern)
{
    for (const Case& test : matching(groups, pattern)) {
        if (judge(test).good) continue;
        bless(test);
        fmt::print("{}\n", filesOf(test.name).golden.string());
    }
    return 0;
}

int run(const std::vector<std::string>& arguments)
{
    const std::string command = arguments.empty() ? "" : arguments[0];
    const std::string name = arguments.size() < 2 ? "" : arguments[1];
    if (arguments.size() > 2) throw UsageError("one name at most");
    setResultFolder(TARN_IMAGE_RESULTS);
    const std::vector<Group> groups = readCases(TARN_IMAGE_CASES);
    if (command == "render") return render(groups, name);
    if (command == "lossless") return lossless(groups, name);
    if (command == "check") return check(groups, name);
    if (command == "verify") return verify(groups, name);
    if (command == "goldens") return checkGoldens(groups);
    if (command == "review") return review(groups, name);
    if (command == "bless") return blessMatching(groups, name);
    throw UsageError("image_tests render [GROUP] | lossless [GROUP] | check CASE | verify [GROUP] | goldens | review "
                     "[PART] | bless [PART]");
}

} // namespace

} // namespace tarn::imagetest

int main(int argc, char** argv)
{
    try {
        return tarn::imagetest::run({argv + 1, argv + argc});
    } catch (const tarn::UsageError& error) {
        std::fprintf(stderr, "image_tests: error: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "image_tests: error: %s\n", error.what());
        return 1;
    }
}
