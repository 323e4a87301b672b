#include "measure/junit.h"

#include "measure/markup.h"

#include <fmt/format.h>

#include <cstddef>

namespace tarn {

namespace {

std::string caseXml(const std::string& suite, const JUnitCase& test)
{
    std::string xml = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", escapedMarkup(suite),
                                  escapedMarkup(test.name), test.seconds);
    const std::string message = escapedMarkup(test.message);
    if (test.result == JUnitCase::Result::passed) {
        if (message.empty()) return xml + "/>\n";
        return xml + fmt::format(">\n      <system-out>{}</system-out>\n    </testcase>\n", message);
    }
    const char* element = test.result == JUnitCase::Result::failed ? "failure" : "error";
    return xml + fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\">{2}</{0}>\n    </testcase>\n", element,
                             escapedMarkup(test.type), message);
}

} // namespace

std::string junitXml(const std::string& suite, const std::vector<JUnitCase>& cases)
{
    std::size_t failures = 0, errors = 0;
    double seconds = 0.0;
    for (const JUnitCase& test : cases) {
        failures += test.result == JUnitCase::Result::failed;
        errors += test.result == JUnitCase::Result::error;
        seconds += test.seconds;
    }
    const std::string counts = fmt::format("name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"",
                                           escapedMarkup(suite), cases.size(), failures, errors, seconds);
    std::string xml = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n  <testsuite {0} skipped=\"0\">\n", counts);
    for (const JUnitCase& test : cases) xml += caseXml(suite, test);
    return xml + "  </testsuite>\n</testsuites>\n";
}

} // namespace tarn
