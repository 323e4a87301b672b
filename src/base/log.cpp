#include "base/log.h"

#include <spdlog/logger.h>
#include <spdlog/sinks/stdout_color_sinks.h>

#include <algorithm>
#include <atomic>
#include <mutex>

namespace tarn::log {

namespace {

std::mutex captureMutex;
std::vector<std::pair<const Capture*, std::vector<Capture::Message>>> captures; // the innermost is the last
std::atomic<Level> lowest{Level::info};

spdlog::logger& logger()
{
    static spdlog::logger instance = [] {
        spdlog::logger made("tarn", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
        made.set_pattern("tarn: %^%l%$: %v");
        made.set_level(spdlog::level::trace); // write() has already dropped what is not wanted
        made.flush_on(spdlog::level::trace);
        return made;
    }();
    return instance;
}

spdlog::level::level_enum spdlogLevel(Level level)
{
    switch (level) {
    case Level::debug: return spdlog::level::debug;
    case Level::info: return spdlog::level::info;
    case Level::warning: return spdlog::level::warn;
    case Level::error: break;
    }
    return spdlog::level::err;
}

} // namespace

void setLevel(Level level) { lowest = level; }

void write(Level level, std::string_view message)
{
    {
        const std::lock_guard lock(captureMutex);
        if (!captures.empty()) {
            captures.back().second.push_back({level, std::string(message)});
            return;
        }
    }
    if (level < lowest) return;
    logger().log(spdlogLevel(level), spdlog::string_view_t(message.data(), message.size()));
}

Capture::Capture()
{
    const std::lock_guard lock(captureMutex);
    captures.emplace_back(this, std::vector<Message>());
}

Capture::~Capture()
{
    const std::lock_guard lock(captureMutex);
    std::erase_if(captures, [this](const auto& entry) { return entry.first == this; });
}

std::vector<Capture::Message> Capture::messages() const
{
    const std::lock_guard lock(captureMutex);
    for (const auto& [capture, messages] : captures)
        if (capture == this) return messages;
    return {};
}

bool Capture::contains(std::string_view text) const
{
    const auto all = messages();
    return std::any_of(all.begin(), all.end(),
                       [&](const Message& message) { return message.text.find(text) != std::string::npos; });
}

} // namespace tarn::log
