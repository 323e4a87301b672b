// The flags of tarn view, which both programs know; only the one with a window runs it (viewer/, no_window.cpp).
#include "app/command_flags.h"
#include "app/commands.h"

namespace tarn {

MakeCommand defineView(Flags& flags)
{
    auto command = std::make_shared<ViewCommand>();
    addSceneFlags(flags, command->scene);
    addViewFlags(flags, command->view);
    flags.toggle("--fullscreen", "Fill the screen", command->fullscreen);
    flags.toggle("--vsync,!--no-vsync", "Wait for the screen's refresh (on by default)", command->vsync);
    flags.count("--frames", "Leave after N frames; 0 stays", command->frames, 0, 1000000);
    flags.number("--fps", "F",
                 "Frames per second to hold by cheaper settings while anything moves (30 by default); 0 shows "
                 "your settings whatever they take",
                 command->fps, 0.0, 1000.0);
    flags.path("--ladder", "FILE",
               "Settings to hold it by, from tarn trade --write-ladder; the shipped ones by default", command->ladder);
    flags.path("--reference", "FILE", "A picture of `tarn reference` to see beside the live one", command->reference);
    return [command] { return *command; };
}

} // namespace tarn
