#include "gl/context.h"

#include "base/error.h"
#include "base/log.h"
#include "gl/api.h"
#include "gl/object.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace tarn::gl {
namespace {

static_assert(!std::is_copy_constructible_v<Object> && std::is_nothrow_move_constructible_v<Object>);

TEST(GlContext, IsCoreProfile33OrNewer)
{
    GLint major = 0, minor = 0, profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(10 * major + minor, 33);
    EXPECT_EQ(profile & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST(GlContext, KnowsWhatItCanDo)
{
    EXPECT_GE(capabilities().maxTextureSize, 1024);
    EXPECT_GE(capabilities().maxSamples, 4) << "OpenGL 3.3 promises four";
    EXPECT_GE(capabilities().maxAnisotropy, 1.0f);
}

TEST(GlContext, CheckErrorsNamesPlaceAndError)
{
    // A message of type error is meant to come here, so it is kept from the listener that fails tests for it.
    if (capabilities().debug) glDisable(GL_DEBUG_OUTPUT);
    glEnable(GL_TEXTURE0);
    if (capabilities().debug) glEnable(GL_DEBUG_OUTPUT);
    try {
        checkErrors("the water pass");
        FAIL() << "an error was pending";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "OpenGL error in the water pass: invalid enum");
    }
    EXPECT_NO_THROW(checkErrors("the next pass"));
}

TEST(GlContext, HeadlessContextNeedsPixels) { EXPECT_THROW(makeHeadlessContext({0, 4}), Error); }

TEST(GlObject, MovesItsNameAndDeletesItOnce)
{
    Object a(Object::Kind::buffer, "moved");
    const Name name = a.name();
    glBindBuffer(GL_COPY_WRITE_BUFFER, name);
    Object b = std::move(a);
    EXPECT_FALSE(a);
    EXPECT_EQ(b.name(), name);
    EXPECT_EQ(b.label(), "moved");
    EXPECT_EQ(glIsBuffer(name), GL_TRUE);
    b = Object();
    EXPECT_EQ(glIsBuffer(name), GL_FALSE);
}

TEST(GlObject, TellsItsLabel)
{
    if (!capabilities().debug) GTEST_SKIP() << "no KHR_debug";
    const Object buffer(Object::Kind::buffer, "vertices of the pier");
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.name());
    buffer.announceLabel();
    char label[64] = {};
    glGetObjectLabel(GL_BUFFER, buffer.name(), sizeof label, nullptr, label);
    EXPECT_STREQ(label, "vertices of the pier");
}

} // namespace
} // namespace tarn::gl
