#include "app/command_line.h"

#include "app/command_description.h"
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/version.h"
#include "base/error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <map>

namespace tarn {

namespace {

struct CommandRow {
    const char* name;
    const char* doc;
    MakeCommand (*define)(Flags&);
};

constexpr CommandRow commands[] = {
    {"view", "Walk round the lake in a window (the default)", defineView},
    {"render", "Write pictures", defineRender},
    {"reference", "Trace the true picture, and what the water hides in it", defineReference},
    {"bench", "Measure what a frame and its passes cost, with the water and without", defineBench},
    {"trade", "Measure what options cost in time and in accuracy, and write a report", defineTrade},
    {"tune", "Find the settings that keep a limit of error or of time on this machine", defineTune},
    {"budget", "Say which part of a picture's error each approximation owns", defineBudget},
    {"explain", "Say which passes a frame runs, and why", defineExplain},
    {"maps", "Write the maps of heights that rays are marched through, as pictures", defineMaps},
    {"compare", "Say how different two pictures are, to the eye and in their values", defineCompare},
    {"disparity", "Say how far a drawn pair's disparity is from the reference's pair", defineDisparity},
    {"options", "List every option", defineOptions},
    {"info", "Say what this program, machine and scene are", defineInfo},
};

bool isCommand(const std::string& word)
{
    return std::any_of(std::begin(commands), std::end(commands),
                       [&](const CommandRow& row) { return word == row.name; });
}

/// Puts the default command in front where none is named. A lone word that is neither a command nor a file
/// nor looks like one is taken for a misspelt command.
std::vector<std::string> withCommand(std::vector<std::string> arguments)
{
    if (!arguments.empty()) {
        const std::string& first = arguments.front();
        if (isCommand(first) || first == "--help" || first == "-h" || first == "--version" || first == "--describe")
            return arguments;
        const bool looksLikeFile = first.find_first_of("./-") != std::string::npos;
        if (!looksLikeFile && !std::filesystem::exists(first)) {
            std::vector<std::string> names;
            for (const CommandRow& row : commands) names.emplace_back(row.name);
            const std::string near = nearestName(first, names);
            throw UsageError("{}: no such command or scene; {}", first,
                             near.empty() ? fmt::format("there are {}", fmt::join(names, ", "))
                                          : fmt::format("did you mean {}?", near));
        }
    }
    arguments.insert(arguments.begin(), "view");
    return arguments;
}

std::string unknownFlagMessage(const CLI::App& app)
{
    const std::string word = app.remaining(true).front();
    if (word.empty() || word.front() != '-') return fmt::format("{}: one argument too many; see --help", word);
    const std::string flag = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands())
        for (const CLI::Option* option : command->get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    const std::string near = nearestName(flag, names);
    return fmt::format("{}: no such flag{}; see --help", flag,
                       near.empty() ? "" : fmt::format(", did you mean {}?", near));
}

} // namespace

Command parseCommandLine(const std::vector<std::string>& arguments)
{
    CLI::App app{"Tarn shows lakes, and knows what its speed costs in accuracy.", "tarn"};
    app.require_subcommand(1);
    app.set_version_flag("--version", fmt::format("tarn {} ({})", versionText(), buildText()));

    std::vector<std::string> words = withCommand(arguments);
    struct Declared {
        std::unique_ptr<Flags> flags;
        MakeCommand make;
    };
    std::map<std::string, Declared> declared; // CLI11 keeps pointers into all of them
    for (const CommandRow& row : commands) {
        auto flags = std::make_unique<Flags>(*app.add_subcommand(row.name, row.doc));
        MakeCommand make = row.define(*flags);
        declared[row.name] = {std::move(flags), std::move(make)};
    }
    const std::string name = words.front();
    if (name == "--describe") {
        if (words.size() > 1) throw UsageError("{}: one argument too many; --describe stands alone", words[1]);
        return PrintCommand{describeCommandLine(app)};
    }

    std::reverse(words.begin(), words.end()); // as CLI11 wants them
    try {
        app.parse(std::move(words));
    } catch (const CLI::CallForHelp&) {
        return PrintCommand{app.help()};
    } catch (const CLI::CallForVersion& version) {
        return PrintCommand{std::string(version.what()) + "\n"};
    } catch (const CLI::ExtrasError&) {
        throw UsageError("{}", unknownFlagMessage(app));
    } catch (const CLI::ParseError& error) {
        throw UsageError("{}; see --help", error.what());
    }
    const Declared& chosen = declared.at(name);
    chosen.flags->convert();
    Command command = chosen.make();
    if (auto* trade = std::get_if<TradeCommand>(&command))
        trade->commandLine = fmt::format("tarn {}", fmt::join(arguments, " "));
    return command;
}

} // namespace tarn
