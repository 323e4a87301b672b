// A display that goes away while the window is open.
#pragma once

namespace tarn {

/// From now on a lost X display ends the program with one line of error and status 1. Xlib leaves no other
/// way: it ends the program itself when the handler returns. Does nothing where there is no X.
void guardDisplay();

} // namespace tarn
