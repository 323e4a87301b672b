// A ladder of settings: from a scene's own down to the cheapest, each rung with what it was measured to cost and to get
// wrong. `tarn trade --write-ladder` takes one from the measured front; the viewer's governor (plan/governor.h) moves
// along it.
//
// A rung sets options to absolute values, but it only ever makes a frame cheaper: from the settings that a person has
// chosen it takes over what lies further from the measured base than they do already (see `below`).
#pragma once

#include "plan/options.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tarn {

/// Values of options by key, as --set would take them.
using OptionValues = std::map<std::string, std::string>;

struct Rung {
    OptionValues settings{};   ///< what differs from the base; none for the first rung, which is the base itself
    double cost = 1.0;         ///< of a frame, as a ratio to the base's
    double milliseconds = 0.0; ///< of a frame, where it was measured
    double flip = 0.0;         ///< mean FLIP against the reference
    double wrongHits = 0.0;    ///< fraction of refracted rays that end more than 5 cm beside the true point
};

struct Ladder {
    std::string scene;         ///< name of the scene that was measured
    std::string size, machine; ///< of the pictures, and what drew them
    OptionValues base;         ///< of every option that a rung sets: what it was while the first rung was measured
    std::vector<Rung> rungs;   ///< costs fall, errors never do
};

/// "" for a ladder that can be climbed, else what is wrong with it: "rung 3: …". Rungs are counted from 1.
std::string faultOf(const Ladder& ladder);

/// The chosen options, cheaper by what a rung changes of the ladder's base. An option stays as it is where it is beyond
/// the rung's value already (counting from the base; names of a choice count in their order), so that what a person has
/// made cheaper, or switched off, stays so.
Options below(const Options& chosen, const Ladder& ladder, const Rung& rung);

/// A ladder over the options that a person has chosen.
struct OwnRung {
    Options options;
    std::size_t rung = 0; ///< of the ladder: what it was measured as
    double cost = 1.0;
};

/// From the chosen options themselves downwards. Rungs that change nothing of the one before are left out.
std::vector<OwnRung> rungsBelow(const Options& chosen, const Ladder& ladder);

/// Whether the chosen options have the base's values wherever rungs set any: then the ladder's errors are theirs.
bool startsAtBase(const Options& chosen, const Ladder& ladder);

/// An option's value as a number that orders its values: that of a choice is how many names stand before it. Throws
/// UsageError where the option has none, such as a colour, and as assign() does. @param origin for its message
double rankAt(const std::string& key, const std::string& value, const std::string& origin = "a ladder");

/// Whether an option is a size or a number that every program takes as it comes. All others may need programs of their
/// own, which a frame in the middle of a movement must not wait for.
bool isSizeOnly(std::string_view key);

/// Whether the programs that were built for some options draw others too, as far as the options tell.
bool programsServe(const Options& built, const Options& wanted);

} // namespace tarn
