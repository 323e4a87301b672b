// The settings that the viewer draws with: a person's own, or cheaper ones that the governor has chosen from the ladder
// while something moves, or those of a picture that is being refined while nothing does. Knows no window.
//
//     GovernedSettings governed(ladder, settings, "The lake", tuning);
//     const GovernedSettings::Part part = governed.next({.now = now, .disturbed = moved, .isStill = paused});
//     …draw with governed.drawn() and part.sample…
//     governed.took({governed.drawn().options, part.sample, milliseconds, now});
#pragma once

#include "app/settings.h"
#include "plan/governor.h"
#include "plan/ladder.h"
#include "plan/refinement.h"

#include <optional>
#include <string>
#include <vector>

namespace tarn {

class GovernedSettings {
public:
    /// @param scene the name of the one that is shown   @param own the person's settings; options.frame.targetMs 0: off
    GovernedSettings(Ladder ladder, const Settings& own, std::string scene, const GovernorTuning& tuning = {});

    /// Returns whether the person has changed them.
    bool setOwn(const Settings& own);
    /// Else the person's own settings are drawn, whatever they take.
    bool isOn() const { return own_.options.frame.targetMs > 0.0f; }

    struct Now {
        double now = 0.0;       ///< s, of a clock that never goes back
        bool disturbed = false; ///< the camera, the window or the settings changed, or a key is held
        bool isStill = false;   ///< nothing in the picture moves
        bool suspended = false; ///< the own settings are wanted for once: they are being measured
    };
    struct Part {
        int sample = 0;          ///< FrameInput::sample
        bool isFinal = false;    ///< the picture was drawn already and nothing better is to come
        bool isRefining = false; ///< it may take longer than the governor allows
    };
    /// Once for each frame, before it is drawn.
    Part next(const Now& now);

    struct Drawn {
        const Options& options;
        int sample = 0;
        double milliseconds = 0.0;
        double now = 0.0; ///< s
    };
    /// After it, unless the last picture was kept. It may be an earlier one than that of the last next().
    void took(const Drawn& frame);

    /// What the next frame is to be drawn with.
    const Settings& drawn() const { return drawn_; }

    /// Options whose programs are worth building now, while nobody moves; nothing when all are there.
    std::optional<Options> toBuild() const;
    /// Programs for these options are there.
    void noteBuilt(const Options& options);

    /// "24 fps, error 0.14, 9 % wrong hits (scale 0.67, …)"; "" while it is off. @param fps as shown
    std::string text(double fps) const;

private:
    void build();
    void noteReady();
    std::string changesText() const;

    Ladder ladder_;
    Settings own_, drawn_;
    std::string scene_;
    GovernorTuning tuning_;
    std::vector<OwnRung> rungs_;
    Governor governor_;
    Refinement refinement_;
    Refinement::Step step_; ///< of the frame that is drawn next or was drawn last
    bool suspended_ = false;
    bool startsAtBase_ = false;
    bool touched_ = true;        ///< the settings were, since the last frame
    std::vector<Options> built_; ///< one for each set of programs
    std::vector<bool> ready_;    ///< of each rung
};

} // namespace tarn
