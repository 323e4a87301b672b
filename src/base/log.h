// Messages for people, on standard error. Results never come this way: they go to standard output.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tarn::log {

enum class Level { debug, info, warning, error };

/// Messages below this level are dropped. The default is info.
void setLevel(Level level);

void write(Level level, std::string_view message);

template <typename... Args> void debug(fmt::format_string<Args...> format, Args&&... args)
{
    write(Level::debug, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args> void info(fmt::format_string<Args...> format, Args&&... args)
{
    write(Level::info, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args> void warning(fmt::format_string<Args...> format, Args&&... args)
{
    write(Level::warning, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args> void error(fmt::format_string<Args...> format, Args&&... args)
{
    write(Level::error, fmt::format(format, std::forward<Args>(args)...));
}

/// Collects every message while it lives instead of printing it. Tests use it to see warnings.
class Capture {
public:
    Capture();
    ~Capture();
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;

    struct Message {
        Level level;
        std::string text;
    };
    std::vector<Message> messages() const;
    /// True when some message holds the text.
    bool contains(std::string_view text) const;
};

} // namespace tarn::log
