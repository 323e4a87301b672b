// Results for build servers: well-formed whatever a file is called.
#include "measure/junit.h"
#include "measure/markup.h"

#include <gtest/gtest.h>

namespace tarn {
namespace {

TEST(EscapedMarkup, LeavesNothingThatMarkupWouldRead)
{
    EXPECT_EQ(escapedMarkup("a & <b> \"c\" 'd'"), "a &amp; &lt;b&gt; &quot;c&quot; &#39;d&#39;");
    EXPECT_EQ(escapedMarkup("a\nb\tc\rd"), "a&#10;b&#9;c&#13;d");
    EXPECT_EQ(escapedMarkup("]]>"), "]]&gt;");
}

TEST(EscapedMarkup, KeepsUtf8AndReplacesWhatIsNone)
{
    const std::string good = "g\u00fcn\u00e9 \u4e00 \U0001f30a";
    EXPECT_EQ(escapedMarkup(good), good);
    const std::string replaced = "\ufffd";
    EXPECT_EQ(escapedMarkup(std::string("a\0b", 3)), "a" + replaced + "b");
    EXPECT_EQ(escapedMarkup("\x1b"), replaced);
    EXPECT_EQ(escapedMarkup("\xff"), replaced);
    EXPECT_EQ(escapedMarkup("\xc3"), replaced);                                              // cut
    EXPECT_EQ(escapedMarkup("\xc3("), replaced + "(");                                       // cut by another character
    EXPECT_EQ(escapedMarkup("\xc0\xaf"), replaced + replaced);                               // overlong
    EXPECT_EQ(escapedMarkup("\xe0\x80\xaf"), replaced + replaced + replaced);                // overlong
    EXPECT_EQ(escapedMarkup("\xed\xa0\x80"), replaced + replaced + replaced);                // surrogate
    EXPECT_EQ(escapedMarkup("\xef\xbf\xbf"), replaced + replaced + replaced);                // U+FFFF
    EXPECT_EQ(escapedMarkup("\xf4\x90\x80\x80"), replaced + replaced + replaced + replaced); // over U+10FFFF
}

TEST(JUnit, CountsAndEscapes)
{
    const std::string xml = junitXml("gold & co", {{"a.png", 0.25, JUnitCase::Result::passed, "", "identical"},
                                                   {"b<.png", 0.5, JUnitCase::Result::failed, "different", "1 > \"0\""},
                                                   {"c.png", 0.0, JUnitCase::Result::error, "error", "no picture"},
                                                   {"d.png", 0.0, JUnitCase::Result::passed, "", ""}});
    EXPECT_EQ(xml, R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="gold &amp; co" tests="4" failures="1" errors="1" time="0.750">
  <testsuite name="gold &amp; co" tests="4" failures="1" errors="1" time="0.750" skipped="0">
    <testcase classname="gold &amp; co" name="a.png" time="0.250">
      <system-out>identical</system-out>
    </testcase>
    <testcase classname="gold &amp; co" name="b&lt;.png" time="0.500">
      <failure type="different" message="1 &gt; &quot;0&quot;">1 &gt; &quot;0&quot;</failure>
    </testcase>
    <testcase classname="gold &amp; co" name="c.png" time="0.000">
      <error type="error" message="no picture">no picture</error>
    </testcase>
    <testcase classname="gold &amp; co" name="d.png" time="0.000"/>
  </testsuite>
</testsuites>
)");
}

} // namespace
} // namespace tarn
