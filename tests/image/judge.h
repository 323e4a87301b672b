// The second half of a picture test: hold the pictures against the goldens. Needs no OpenGL.
#pragma once

#include "image/cases.h"

#include <string>
#include <vector>

namespace tarn::imagetest {

struct Verdict {
    bool good = false;
    std::string text; ///< one line
};

/// A golden that is missing or has another size, and a picture that was not rendered, are failures.
Verdict judge(const Case& test);

/// One page for all of the cases.
void writePage(const std::filesystem::path& file, const std::string& title, const std::vector<Case>& cases);

/// What is wrong with the goldens as a set: two that would pass for each other, so that the tolerance says
/// nothing, and files that belong to no case.
std::vector<std::string> problemsOfGoldens(const std::vector<Case>& cases);

/// Makes the rendered picture the golden. Throws Error when there is none.
void bless(const Case& test);

} // namespace tarn::imagetest
