#include "image/cases.h"

#include "base/error.h"
#include "base/files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace tarn::imagetest {

namespace {

using nlohmann::json;

constexpr std::array<const char*, 11> caseKeys = {"name", "what", "camera", "eye",  "target", "up",
                                                  "fov",  "time", "size",   "view", "options"};

std::optional<vec3> readVector(const json& object, const char* key)
{
    if (!object.contains(key)) return std::nullopt;
    const auto values = object.at(key).get<std::vector<float>>();
    if (values.size() != 3) throw Error("{}: three numbers are wanted", key);
    return vec3(values[0], values[1], values[2]);
}

/// An option's value as --set takes it.
std::string valueText(const json& value)
{
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_array()) return value.dump();
    std::vector<std::string> parts;
    for (const json& part : value) parts.push_back(part.dump());
    return fmt::format("{}", fmt::join(parts, ","));
}

void requireKnownKeys(const json& object)
{
    for (const auto& [key, value] : object.items())
        if (std::find(caseKeys.begin(), caseKeys.end(), key) == caseKeys.end())
            throw Error("{}: no such key; there are {}", key, fmt::join(caseKeys, ", "));
}

Case readCase(const json& object)
{
    requireKnownKeys(object);
    Case result;
    result.name = object.at("name").get<std::string>();
    result.what = object.at("what").get<std::string>();
    result.camera.name = object.value("camera", "");
    result.camera.eye = readVector(object, "eye");
    result.camera.target = readVector(object, "target");
    result.camera.up = readVector(object, "up");
    if (object.contains("fov")) result.camera.verticalFov = glm::radians(object.at("fov").get<float>());
    result.time = object.value("time", 0.0);
    if (object.contains("size")) {
        const auto size = object.at("size").get<std::array<int, 2>>();
        result.size = {size[0], size[1]};
    }
    const std::string view = object.value("view", "final");
    if (!debugViewFromName(view)) throw Error("view {}: no such view", view);
    result.view = *debugViewFromName(view);
    if (object.contains("options"))
        for (const auto& [key, value] : object.at("options").items())
            result.settings.push_back(fmt::format("{}={}", key, valueText(value)));
    return result;
}

} // namespace

std::vector<Group> readCases(const std::filesystem::path& file)
{
    std::vector<Group> groups;
    std::set<std::string> names;
    std::string place = "the file";
    try {
        const json root = json::parse(readFile(file));
        for (const json& object : root.at("groups")) {
            Group group;
            group.name = object.at("name").get<std::string>();
            place = "group " + group.name;
            group.scene = projectRoot() / object.at("scene").get<std::string>();
            for (const json& caseObject : object.at("cases")) {
                place = "case " + caseObject.value("name", std::string("without a name"));
                group.cases.push_back(readCase(caseObject));
                if (!names.insert(group.cases.back().name).second) throw Error("there are two of that name");
            }
            groups.push_back(std::move(group));
        }
    } catch (const std::exception& error) {
        throw Error("{}: {}: {}", file.string(), place, error.what());
    }
    return groups;
}

std::filesystem::path goldenFolder() { return TARN_GOLDENS; }
namespace {

std::filesystem::path& results()
{
    static std::filesystem::path folder;
    return folder;
}

} // namespace

std::filesystem::path resultFolder() { return results(); }
void setResultFolder(std::filesystem::path folder) { results() = std::move(folder); }

CaseFiles filesOf(const std::string& caseName)
{
    return {goldenFolder() / (caseName + ".png"), resultFolder() / (caseName + ".png"),
            resultFolder() / (caseName + ".problem"), resultFolder() / (caseName + ".html")};
}

} // namespace tarn::imagetest
