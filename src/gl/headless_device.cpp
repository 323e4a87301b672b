// Which device headless contexts are made on. In a file of its own: what headlessDevices() is, only programs know that
// make such contexts.
#include "base/error.h"
#include "gl/context.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace tarn::gl {

namespace {

std::string& chosenDevice()
{
    static std::string name;
    return name;
}

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

} // namespace

void chooseHeadlessDevice(std::string name)
{
    chosenDevice() = std::move(name);
    const std::vector<std::string> all = headlessDevices();
    if (chosenDevice().empty() || std::any_of(all.begin(), all.end(), isChosenDevice)) return;
    throw Error("there is no device '{}' to draw on; there {} {}", std::exchange(chosenDevice(), ""),
                all.size() == 1 ? "is" : "are", fmt::join(all, ", "));
}

bool isChosenDevice(const std::string& name)
{
    return lowerCase(name).find(lowerCase(chosenDevice())) != std::string::npos;
}

} // namespace tarn::gl
