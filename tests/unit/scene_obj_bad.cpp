// Bad OBJ files: what can be drawn is drawn, with a warning that names file and line; what cannot is one
// error.
#include "base/error.h"
#include "base/log.h"
#include "scene/scene_file.h"
#include "temp_folder.h"

#include <cmath>
#include <random>

namespace tarn::test {
namespace {

const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"; // lines 1 to 4

class BadObjTest : public ::testing::Test {
protected:
    TempFolder folder;
    log::Capture log;

    /// Loads, and expects this many triangles and a warning at test.obj:line that holds the text.
    void expectDrawn(const std::string& text, std::size_t triangles, int line, const std::string& warning)
    {
        const Scene scene = loadScene(folder.file("test.obj", text));
        EXPECT_EQ(scene.meshes.at(0).indices.size(), 3 * triangles);
        for (const Vertex& v : scene.meshes[0].vertices)
            EXPECT_TRUE(std::isfinite(v.position.x + v.position.y + v.position.z + v.normal.x + v.uv.x));
        const std::string place = "test.obj:" + std::to_string(line) + ": ";
        bool found = false;
        for (const auto& message : log.messages())
            found |= message.text.find(place) != std::string::npos && message.text.find(warning) != std::string::npos;
        EXPECT_TRUE(found) << "no warning '" << place << "… " << warning << "'; the last was "
                           << (log.messages().empty() ? "none" : log.messages().back().text);
    }

    std::string problem(const std::filesystem::path& file)
    {
        return messageOf<Error>([&] { loadScene(file); });
    }
};

TEST_F(BadObjTest, NothingToOpen)
{
    EXPECT_CONTAINS(problem(folder.path() / "none.obj"), "none.obj: no such file");
    std::filesystem::create_directory(folder.path() / "dir.obj");
    EXPECT_CONTAINS(problem(folder.path() / "dir.obj"), "dir.obj: is a directory");
    EXPECT_CONTAINS(problem(folder.file("x.txt", "hello")), "a scene is a .toml or a .obj file");
}

TEST_F(BadObjTest, NothingInIt)
{
    EXPECT_CONTAINS(problem(folder.file("empty.obj", "")), "empty.obj: the file is empty");
    EXPECT_CONTAINS(problem(folder.file("blank.obj", "\n\n# nothing\n")), "no usable face");
    EXPECT_CONTAINS(problem(folder.file("points.obj", quad)), "no usable face");
    EXPECT_CONTAINS(problem(folder.file("only.obj", "f 1 2 3\n")), "no usable face");
    EXPECT_CONTAINS(problem(folder.file("same.obj", quad + "f 1 1 1\n")), "different corners");
}

TEST_F(BadObjTest, BinaryJunk)
{
    EXPECT_CONTAINS(problem(folder.file("zero.obj", std::string("v 0 0\0 0\n", 9))), "binary data at byte 5");
    std::mt19937 random(1);
    for (int round = 0; round < 50; ++round) {
        std::string junk;
        for (int i = 0; i < 2000; ++i) junk += static_cast<char>(random() % 255 + 1);
        EXPECT_CONTAINS(problem(folder.file("junk.obj", junk)), "junk.obj: nothing to draw");
    }
}

TEST_F(BadObjTest, IndexOutOfRange)
{
    expectDrawn(quad + "f 1 2 3\nf 1 2 5\n", 1, 6, "vertex index 5 is out of range (there are 4)");
    expectDrawn(quad + "f 1 2 3\nf 1 2 99999999999999\n", 1, 6, "out of range");
    expectDrawn(quad + "vt 0 0\nf 1 2 3\nf 1/1 2/2 3/1\n", 1, 7, "texture coordinate index 2 is out of range");
    expectDrawn(quad + "vn 0 0 1\nf 1 2 3\nf 1//1 2//1 3//2\n", 1, 7, "normal index 2 is out of range");
}

TEST_F(BadObjTest, ZeroAndRelativeOutOfRange)
{
    expectDrawn(quad + "f 1 2 3\nf 0 1 2\n", 1, 6, "vertex index 0 is out of range");
    expectDrawn(quad + "f 1 2 3\nf -5 1 2\n", 1, 6, "vertex index -5 is out of range (there are 4)");
    expectDrawn("v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 1 1 0\nf -1 -2 -3\n", 1, 3, "out of range (there are 2)");
}

TEST_F(BadObjTest, NotANumber)
{
    for (const char* value : {"nan", "inf", "-inf", "1e999", "1e38", "abc", "1.2.3", "0x10", "1e", "--1",
                              "999999999999999999999999999999999999999999"}) {
        const std::string text = quad + "v 0 " + value + " 0\nf 1 2 3\nf 1 2 5\n";
        SCOPED_TRACE(value);
        expectDrawn(text, 1, 5, "coordinate is not a finite number");
        expectDrawn(text, 1, 7, "uses a vertex that was left out");
    }
    expectDrawn(quad + "vt nan 0\nf 1/1 2/1 3/1\n", 1, 5, "texture coordinate is not a finite number");
    expectDrawn(quad + "vn 0 inf 0\nf 1//1 2//1 3//1\n", 1, 5, "normal is not a finite number");
}

TEST_F(BadObjTest, TooFewNumbersKeepTheNumbering)
{
    expectDrawn("v 0 0\n" + quad + "f 2 3 4\nf 1 2 3\n", 1, 1, "coordinate with 2 numbers instead of 3");
    expectDrawn("v\n" + quad + "f 1 2 3\n", 1, 1, "'v' without numbers");
}

TEST_F(BadObjTest, FacesWithTooFewCorners)
{
    expectDrawn(quad + "f 1 2 3\nf 1 2\n", 1, 6, "2 corners instead of 3");
    expectDrawn(quad + "f 1 2 3\nf\n", 1, 6, "0 corners");
    expectDrawn(quad + "f 1 2 3\nf 1 2 # 3\n", 1, 6, "2 corners");
}

TEST_F(BadObjTest, MangledIndices)
{
    for (const char* face :
         {"f 1/ 2 3", "f 1/1/ 2 3", "f 1// 2// 3//", "f a b c", "f 1.5 2 3", "f 1/1/1/1 2 3", "f / 2 3", "f 1 2 3,"}) {
        SCOPED_TRACE(face);
        expectDrawn(quad + "vt 0 0\nvn 0 0 1\nf 1 2 3\n" + face + "\n", 1, 8, "face left out");
    }
}

TEST_F(BadObjTest, TruncatedLastLine)
{
    expectDrawn(quad + "f 1 2 3\nf 1 2", 1, 6, "is it cut short?");
    expectDrawn(quad + "f 1 2 3\nv 1.5 0", 1, 6, "is it cut short?");
    expectDrawn(quad + "f 1 2 3\nvn", 1, 6, "is it cut short?");
    expectDrawn(quad + "f 1 2 3\nf 1/", 1, 6, "is it cut short?");
}

TEST_F(BadObjTest, EveryTruncationIsSafe)
{
    const std::string text =
        "mtllib x y.mtl\n" + quad + "vt 0.5 1e-3\nvn 0 0 1\ns 1\nusemtl a\n" + "f 1/1/1 2/1/1 3//1 -1/1\nf 3 4 1\n";
    for (std::size_t length = 0; length <= text.size(); ++length) {
        const auto file = folder.file("cut.obj", text.substr(0, length));
        try {
            EXPECT_GE(loadScene(file).meshes.at(0).indices.size(), 3u);
        } catch (const Error& error) {
            EXPECT_CONTAINS(error.what(), "cut.obj: ");
        }
    }
}

TEST_F(BadObjTest, RandomEditsAreSafe)
{
    const std::string text = quad + "vt 0 0\nvt 1 1\nvn 0 0 1\ns 1\nf 1/1/1 2/2/1 3/1/1\nf -1 -2 -3\nf 1//1 3 4\n";
    const std::string alphabet = "0123456789-+./ \t\nvfsntlu#\\e\r";
    std::mt19937 random(7);
    int drawn = 0;
    for (int round = 0; round < 1500; ++round) {
        std::string edited = text;
        for (int edit = 0; edit < 4; ++edit) {
            const std::size_t at = random() % edited.size();
            const char c = alphabet[random() % alphabet.size()];
            if (random() % 3 == 0)
                edited.erase(at, 1);
            else if (random() % 2 == 0)
                edited.insert(at, 1, c);
            else
                edited[at] = c;
        }
        try {
            const Mesh mesh = loadScene(folder.file("edit.obj", edited)).meshes.at(0);
            for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
            for (const Vertex& v : mesh.vertices)
                ASSERT_TRUE(std::isfinite(v.position.x + v.position.y + v.position.z)) << edited;
            ++drawn;
        } catch (const Error&) {
        }
    }
    EXPECT_GT(drawn, 500) << "too few edits leave something to draw for this to be a test";
}

TEST_F(BadObjTest, ManyWarningsAreCounted)
{
    std::string text = quad + "f 1 2 3\n";
    for (int i = 0; i < 50; ++i) text += "f 1 2 9\n";
    loadScene(folder.file("test.obj", text));
    EXPECT_EQ(log.messages().size(), 11u);
    EXPECT_TRUE(log.contains("40 more warnings"));
}

TEST_F(BadObjTest, UnknownRecordsAreSkipped)
{
    expectDrawn(quad + "wobble 1 2 3\nf 1 2 3\n", 1, 5, "'wobble' is not understood");
}

TEST_F(BadObjTest, MissingLibraryAndMaterial)
{
    expectDrawn("mtllib none.mtl\n" + quad + "usemtl red\nf 1 2 3\n", 1, 1, "none.mtl: no such file");
    expectDrawn("mtllib none.mtl\n" + quad + "usemtl red\nf 1 2 3\n", 1, 6, "there is no material 'red'; drawn grey");
    std::filesystem::create_directory(folder.path() / "dir.mtl");
    expectDrawn("mtllib dir.mtl\n" + quad + "f 1 2 3\n", 1, 1, "is a directory");
    const Scene scene = loadScene(folder.path() / "test.obj");
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].diffuse, vec3(0.8f));
}

} // namespace
} // namespace tarn::test
