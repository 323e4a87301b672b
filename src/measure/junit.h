// Results of tests in the XML of JUnit, which every build server reads.
#pragma once

#include <string>
#include <vector>

namespace tarn {

struct JUnitCase {
    enum class Result { passed, failed, error }; ///< error: the test could not be made

    std::string name;
    double seconds = 0.0;
    Result result = Result::passed;
    std::string type;    ///< kind of failure: "different"
    std::string message; ///< of the failure, or what there is to say of a case that passed
};

/// The text of a file with one suite. Names and messages are escaped.
std::string junitXml(const std::string& suite, const std::vector<JUnitCase>& cases);

} // namespace tarn
