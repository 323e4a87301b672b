// Values that an option takes one after another: --sweep refraction.steps=1:8.
//
//     KEY=1:8          1, 2, … 8
//     KEY=0:1:0.25     in steps of 0.25
//     KEY=1:64:*2      1, 2, 4, … 64
//     KEY=128,256,512  these; names too: caustics.method=cpu,fetch
//     KEY=0.1,0.2,0.3;0.4  with a semicolon anywhere, commas belong to the values
//     KEY=a,b@OTHER=c  while another option, which these values are of no effect without, has a value of its own
#pragma once

#include "base/fields.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tarn {

/// Options by key, over those of a base.
using Changes = std::map<std::string, std::string>;

/// Every option as it is with these changes over the base. Throws UsageError as assign() does, with `origin`.
using DescribeSettings = std::function<std::vector<FieldRow>(const Changes& changes, const std::string& origin)>;

struct Sweep {
    std::string key;
    std::vector<std::string> values; ///< as the option writes them, each once, in the order given
    Changes with{};                  ///< what else is set while it is swept

    /// What a value changes of the base.
    Changes changes(const std::string& value) const;
    /// The key, and what else is set: "heights.march (refraction.method=raycast)".
    std::string title() const;
};

/// Throws UsageError when the text has not this form, when there is no such option or when it refuses a
/// value.
Sweep parseSweep(std::string_view text, const DescribeSettings& describe);

/// The same for several; no option may be swept twice with the same others.
std::vector<Sweep> parseSweeps(const std::vector<std::string>& texts, const DescribeSettings& describe);

} // namespace tarn
