// The viewer of a program that has no window.
#include "app/program.h"
#include "base/error.h"

namespace tarn {

void runViewer(const ViewCommand&)
{
    throw Error("tarn-osmesa has no window; use tarn view, or tarn-osmesa render --out FILE for a picture");
}

} // namespace tarn
