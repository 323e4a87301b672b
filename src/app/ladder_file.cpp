#include "app/ladder_file.h"

#include "app/options_table.h"
#include "base/error.h"
#include "base/files.h"

#include <algorithm>

namespace tarn {

namespace {

constexpr auto remedy = "write it anew with tarn trade --write-ladder FILE";

/// A file and what is read of it; every complaint names a line.
class Reader {
public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    [[noreturn]] void fail(const toml::node& node, const std::string& what) const
    {
        throw Error("{}:{}: {}; {}", file_, node.source().begin.line, what, remedy);
    }

    void onlyKeys(const toml::table& table, const std::vector<std::string>& keys) const
    {
        for (const auto& [key, node] : table) {
            const std::string name(key.str());
            if (std::find(keys.begin(), keys.end(), name) != keys.end()) continue;
            const std::string near = nearestName(name, keys);
            fail(node,
                 fmt::format("unknown key {}{}", name, near.empty() ? "" : fmt::format(", did you mean {}?", near)));
        }
    }

    const toml::node& required(const toml::table& table, const char* key) const
    {
        const toml::node* node = table.get(key);
        if (!node) fail(table, fmt::format("{} is missing", key));
        return *node;
    }

    std::string text(const toml::table& table, const char* key) const
    {
        const toml::node& node = required(table, key);
        if (!node.is_string()) fail(node, fmt::format("{} wants a text in quotes", key));
        return node.as_string()->get();
    }

    double number(const toml::table& table, const char* key) const
    {
        const toml::node& node = required(table, key);
        const auto value = node.value<double>();
        if (!value || !node.is_number()) fail(node, fmt::format("{} wants a number", key));
        return *value;
    }

    OptionValues settings(const toml::table& table) const
    {
        OptionValues values;
        try {
            for (const Assignment& assignment : assignmentsOf(table, file_)) {
                rankAt(assignment.key, assignment.value, assignment.origin);
                values[assignment.key] = assignment.value;
            }
        } catch (const UsageError& error) { // the file's mistake, not the command line's; it says where
            throw Error("{}; {}", error.what(), remedy);
        }
        return values;
    }

private:
    std::string file_;
};

Rung rungOf(const Reader& reader, const toml::table& table)
{
    reader.onlyKeys(table, {"cost", "milliseconds", "flip", "wrong_hits", "settings"});
    Rung rung;
    rung.cost = reader.number(table, "cost");
    rung.milliseconds = reader.number(table, "milliseconds");
    rung.flip = reader.number(table, "flip");
    rung.wrongHits = reader.number(table, "wrong_hits");
    if (const toml::node* settings = table.get("settings")) {
        if (!settings->is_table()) reader.fail(*settings, "settings wants a table of options");
        rung.settings = reader.settings(*settings->as_table());
    }
    return rung;
}

} // namespace

std::filesystem::path shippedLadder() { return projectRoot() / "assets" / "presets" / "ladder.toml"; }

Ladder readLadder(const std::filesystem::path& file)
{
    const std::string text = readFile(file);
    toml::table table;
    try {
        table = toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        throw Error("{}:{}: {}; {}", file.string(), error.source().begin.line, error.description(), remedy);
    }
    const Reader reader(file.string());
    reader.onlyKeys(table, {"scene", "size", "machine", "base", "rungs"});
    Ladder ladder{reader.text(table, "scene"), reader.text(table, "size"), reader.text(table, "machine"), {}, {}};
    const toml::node& base = reader.required(table, "base");
    if (!base.is_table()) reader.fail(base, "base wants a table of options");
    ladder.base = reader.settings(*base.as_table());
    const toml::node& rungs = reader.required(table, "rungs");
    if (!rungs.is_array_of_tables()) reader.fail(rungs, "rungs wants tables: [[rungs]]");
    for (const toml::node& node : *rungs.as_array()) {
        ladder.rungs.push_back(rungOf(reader, *node.as_table()));
        // One by one, so that the complaint names the rung's own line.
        if (const std::string fault = faultOf(ladder); !fault.empty()) reader.fail(node, fault);
    }
    return ladder;
}

} // namespace tarn
