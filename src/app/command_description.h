// The command line in a form that other programs read: what completions, the man page and the check of the
// documents are made from (tarn --describe).
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace tarn {

/// JSON: the subcommands in the order of --help, each with its flags and arguments.
std::string describeCommandLine(const CLI::App& app);

} // namespace tarn
