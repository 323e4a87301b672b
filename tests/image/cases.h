// The picture tests as cases.json lists them, and where their pictures are.
#pragma once

#include "app/command_line.h"
#include "render/debug_view.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tarn::imagetest {

struct Case {
    std::string name; ///< of the golden, of the test
    std::string what; ///< what the case is there for: the first thing to read when it fails
    CameraArguments camera;
    double time = 0.0; ///< s
    ivec2 size{320, 240};
    std::vector<std::string> settings; ///< "key=value"
    DebugView view = DebugView::final;
};

/// Cases that share a scene are rendered by one process, which loads it once.
struct Group {
    std::string name;
    std::filesystem::path scene;
    std::vector<Case> cases;
};

/// Throws Error that names the case and the key. No name occurs twice.
std::vector<Group> readCases(const std::filesystem::path& file);

/// Where the pictures of a case are.
struct CaseFiles {
    std::filesystem::path golden;
    std::filesystem::path actual;
    std::filesystem::path problem; ///< a line of text: why there is no actual picture
    std::filesystem::path page;    ///< HTML, when the case failed
};
CaseFiles filesOf(const std::string& caseName);

std::filesystem::path goldenFolder();
/// Of the program that asks: set once, before any other use.
std::filesystem::path resultFolder();
void setResultFolder(std::filesystem::path folder);

} // namespace tarn::imagetest
