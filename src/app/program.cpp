#include "app/program.h"

#include "app/commands.h"
#include "base/error.h"
#include "gl/context.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <type_traits>

namespace tarn {

namespace {

int fail(std::string message, int status)
{
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::fprintf(stderr, "tarn: error: %s\n", message.c_str());
    return status;
}

constexpr auto runHeadless = [](const auto& command) {
    if constexpr (requires { command.scene.device; }) gl::chooseHeadlessDevice(command.scene.device);
    if constexpr (!std::is_same_v<decltype(command), const ViewCommand&>) run(command);
};

} // namespace

int runProgram(const std::vector<std::string>& arguments, const std::function<void(const ViewCommand&)>& view)
{
    try {
        const Command command = parseCommandLine(arguments);
        if (const auto* viewCommand = std::get_if<ViewCommand>(&command)) {
            if (!viewCommand->scene.device.empty())
                throw UsageError(
                    "--device is for what draws without a window; a window is on the device of its screen");
            view(*viewCommand);
        } else {
            std::visit(runHeadless, command);
        }
        // A full disk behind standard output shows only here.
        if (std::fflush(stdout) != 0) return fail("standard output cannot be written", 1);
        return 0;
    } catch (const UsageError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail("not enough memory; try a smaller picture or scene", 1);
    } catch (const std::exception& error) {
        return fail(error.what(), 1);
    }
}

} // namespace tarn
