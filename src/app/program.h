// The program, apart from its entry point: arguments in, exit status out.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tarn {

struct ViewCommand;

/// Defined twice: in src/app/viewer for the program tarn, in no_window.cpp for tarn-osmesa.
void runViewer(const ViewCommand& command);

/// 0: good; 1: failed; 2: wrong usage. A failure is one line on standard error, "tarn: error: …".
/// @param arguments without the program's name   @param view what the view command does
int runProgram(const std::vector<std::string>& arguments, const std::function<void(const ViewCommand&)>& view);

} // namespace tarn
