#include "app/command_description.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace tarn {

namespace {

using Json = nlohmann::ordered_json;

Json describe(const CLI::Option& option)
{
    Json names = Json::array();
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    Json json;
    json["names"] = names; // none: an argument
    const bool takesValue = option.get_items_expected_max() > 0;
    json["value"] = takesValue ? option.get_type_name() : "";
    json["doc"] = option.get_description();
    if (option.get_positional()) json["argument"] = option.get_single_name();
    if (takesValue && option.get_items_expected_min() == 0) json["value_optional"] = true;
    if (takesValue && option.get_expected_max() > 1) json["repeated"] = true;
    return json;
}

Json describeOptions(const CLI::App& app)
{
    Json options = Json::array();
    for (const CLI::Option* option : app.get_options()) options.push_back(describe(*option));
    return options;
}

} // namespace

std::string describeCommandLine(const CLI::App& app)
{
    Json json;
    json["name"] = app.get_name();
    json["doc"] = app.get_description();
    json["options"] = describeOptions(app);
    json["commands"] = Json::array();
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        json["commands"].push_back({{"name", command->get_name()},
                                    {"doc", command->get_description()},
                                    {"options", describeOptions(*command)}});
    return json.dump(2) + "\n";
}

} // namespace tarn
