// The subcommands: what flags each has, and what it does. Results go to standard output; each throws Error when it
// fails.
#pragma once

#include "app/command_line.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>

namespace tarn {

class Flags;

/// Makes a command once its flags have their values. Throws UsageError for values that do not go together.
using MakeCommand = std::function<Command()>;

/// Each declares the flags of one command, in the file that runs it.
MakeCommand defineView(Flags& flags);
MakeCommand defineRender(Flags& flags);
MakeCommand defineReference(Flags& flags);
MakeCommand defineBench(Flags& flags);
MakeCommand defineTrade(Flags& flags);
MakeCommand defineTune(Flags& flags);
MakeCommand defineBudget(Flags& flags);
MakeCommand defineExplain(Flags& flags);
MakeCommand defineMaps(Flags& flags);
MakeCommand defineCompare(Flags& flags);
MakeCommand defineDisparity(Flags& flags);
MakeCommand defineOptions(Flags& flags);
MakeCommand defineInfo(Flags& flags);

void run(const PrintCommand& command);
void run(const RenderCommand& command);
void run(const ReferenceCommand& command);
void run(const BenchCommand& command);
void run(const TradeCommand& command);
void run(const TuneCommand& command);
void run(const BudgetCommand& command);
void run(const ExplainCommand& command);
void run(const MapsCommand& command);
void run(const CompareCommand& command);
void run(const DisparityCommand& command);
void run(const OptionsCommand& command);
void run(const InfoCommand& command);

/// bench --startup.
void benchStartup(const BenchCommand& command);

/// To the file, or to standard output when it is "-". Does nothing when it is empty.
void writeJson(const std::string& file, const nlohmann::json& json);

/// Throws Error when writeJson could not write to it; call before long work.
void requireWritableJson(const std::string& file);

} // namespace tarn
