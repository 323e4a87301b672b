// What is shown while nobody moves: the picture is refined in steps, and the first touch brings back the fluid one.
// Pure.
//
//     Refinement refinement;
//     const Refinement::Step step = refinement.next({now, disturbed, still}, governor, isReady);
//
// While the waves move, only the governor's own choice is drawn. In a still picture, time is no object, yet a person
// may come back at any moment and must not have to wait for long: a frame may take at most as long as nothing has been
// touched. Up on the settings' own rung, frames that are jittered within a pixel are averaged until they are as smooth
// as supersampling; then nothing is left to be drawn.
#pragma once

#include "base/math.h"
#include "plan/governor.h"

#include <cstddef>

namespace tarn {

class Refinement {
public:
    struct Input {
        double now = 0.0;       ///< s
        bool disturbed = false; ///< camera, input or settings have changed since the last frame
        bool isStill = false;   ///< nothing in the picture moves
    };
    struct Step {
        std::size_t rung = 0; ///< of the frame to be drawn
        int sample = 0;       ///< 0: the frame alone; n: the n-th of those that are averaged, from 1
        bool isFinal = false; ///< it was drawn already, and nothing better is to come
    };

    static constexpr double secondsOfRest = 0.3; ///< before anything is refined
    static constexpr int samples = 16;           ///< as supersampling = 4 has

    /// @param isReady whether a rung needs no programs built first; empty: none does
    Step next(const Input& input, const Governor& governor, const Governor::IsReady& isReady = {});

    /// Nothing was touched for a while: there is time to build programs.
    bool isResting() const { return resting_; }
    /// The rung that is to be drawn as soon as its programs are there.
    std::size_t wanted() const { return wanted_; }

private:
    double touched_ = 0.0; ///< s: when anything was
    bool begun_ = false, resting_ = false;
    std::size_t rung_ = 0, wanted_ = 0; ///< while it rests
    int sample_ = 0;
};

/// Where within a pixel the n-th of the averaged samples lies, from its middle, in pixels; n from 1. The first is the
/// middle itself, so that the average begins with the picture that is there.
vec2 jitterOf(int sample);

/// How much of a pixel's edge the n-th sample stands for: waves and ripples that fade because a pixel cannot show them
/// are shown by sixteen. The first stands for all of it, for the same reason.
float footprintOf(int sample);

} // namespace tarn
