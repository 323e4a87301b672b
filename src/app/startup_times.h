// What happened when on the way from the start of the process to the picture with all settings.
#pragma once

#include <array>
#include <mutex>
#include <optional>
#include <string>

namespace tarn {

enum class StartupEvent { context, draftPrograms, loaded, uploaded, draftPicture, programs, fullPicture };
inline constexpr std::size_t startupEventCount = 7;

struct StartupEventInfo {
    const char* name; ///< in JSON
    const char* what; ///< in the table
};
inline constexpr std::array<StartupEventInfo, startupEventCount> startupEvents = {
    {{"context", "window or context is there"},
     {"draft_programs", "programs of the draft are built"},
     {"loaded", "scene is read"},
     {"uploaded", "scene is on the graphics card"},
     {"draft_picture", "first picture: the draft"},
     {"programs", "all programs are built"},
     {"full_picture", "picture with the settings"}}};

/// Times since the process began, s.
struct StartupTime {
    double wall = 0.0;
    double processor = 0.0; ///< of all threads
};

/// From any thread.
class StartupTimes {
public:
    /// The first time counts.
    void note(StartupEvent event);
    std::optional<StartupTime> at(StartupEvent event) const;

private:
    mutable std::mutex mutex_;
    std::array<std::optional<StartupTime>, startupEventCount> times_;
};

/// Now.
StartupTime sinceProcessStart();

} // namespace tarn
