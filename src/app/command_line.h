// What a person asked for: arguments in, one plain struct out. The flags of each command stand in its own file
// (command_flags.h).
#pragma once

#include "app/settings.h"
#include "base/math.h"
#include "measure/disparity.h"
#include "measure/flip.h"
#include "measure/paper_tables.h"
#include "measure/water_errors.h"
#include "reference/options.h"
#include "render/debug_view.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tarn {

struct SceneArguments {
    std::filesystem::path file; ///< empty: the shipped lake
    std::optional<float> waterLevel;
    SettingsArguments settings;
    std::string device{}; ///< to draw on without a window (gl::chooseHeadlessDevice)
};

/// A named camera of the scene (its first by default), and what replaces parts of it.
struct CameraArguments {
    std::string name;
    std::optional<vec3> eye, target, up;
    std::optional<float> verticalFov; ///< radians

    bool isGiven() const { return !name.empty() || eye || target || up || verticalFov; }
};

struct ViewArguments {
    CameraArguments camera;
    ivec2 size{1280, 720};                     ///< pixels
    double time = 0.0;                         ///< s
    bool sizeGiven = false, timeGiven = false; ///< on the command line
};

struct ViewCommand {
    SceneArguments scene;
    ViewArguments view;
    bool fullscreen = false;
    bool vsync = true;
    int frames = 0;                  ///< leaves after so many; 0: stays
    std::optional<double> fps;       ///< that the governor holds; 0: it is off
    std::filesystem::path ladder;    ///< that it moves along; empty: the shipped one
    std::filesystem::path reference; ///< a picture of `tarn reference` to compare with; empty: none
};

struct RenderCommand {
    SceneArguments scene;
    ViewArguments view;
    DebugView debugView = DebugView::final;
    int frames = 1;
    double fps = 30.0;
    std::string out; ///< file, pattern with %04d, or folder with allCameras
    bool allCameras = false;
    bool check = false;
    std::optional<ErrorKind> error;  ///< a map of it, instead of the picture
    std::filesystem::path reference; ///< what it is held against
    double errorScale = 0.0;         ///< error of full colour, in its unit; 0: the kind's own
    std::string json;                ///< file, "-" for standard output, or empty
};

struct BenchCommand {
    SceneArguments scene;
    ViewArguments view;
    int frames = 60;
    int warmUp = 5;
    std::vector<std::string> variants; ///< "key=value": one more configuration each
    bool flight = false;               ///< past all of the scene's cameras
    bool yardstick = false;            ///< tells every configuration as a multiple of it too
    bool startup = false;              ///< measures the way to the first pictures instead
    bool rules = false;                ///< measures the plan's rules: without each, and without all of them
    bool interactive = false;          ///< a recorded flight at its real speed instead
    double seconds = 20.0;             ///< that it takes
    const PaperTable* table = nullptr; ///< measures its rows instead; null: none asked for
    std::string json;
};

struct ReferenceCommand {
    SceneArguments scene;
    ViewArguments view;
    reference::ReferenceOptions reference;
    std::string out; ///< .exr with every channel, or .png as shown
    std::string json;
};

struct TradeCommand {
    SceneArguments scene;
    std::filesystem::path out;       ///< folder
    std::vector<std::string> sweeps; ///< "key=values"; empty: the default plan
    bool grid = false;
    std::vector<std::string> views; ///< names of cameras; empty: the first eight
    bool presetsOnly = false;       ///< the base and the presets, and no sweeps
    std::vector<double> times;      ///< s; empty: two moments, at which the views take turns
    ivec2 size{320, 240};           ///< pixels
    int frames = 3;                 ///< frames timed of each setting in each view
    int samples = 32;               ///< of the reference, through each pixel
    int shard = 1, shards = 1;      ///< this part of so many
    std::vector<std::filesystem::path> merge;
    bool fresh = false;
    std::filesystem::path writePresets; ///< folder, or empty
    std::filesystem::path writeLadder;  ///< file, or empty: the plan is that of a ladder
    std::string commandLine;            ///< as given, for the report
};

struct TuneCommand {
    SceneArguments scene;
    std::optional<double> maxError; ///< mean FLIP; exactly one of the two
    std::optional<double> budgetMs;
    std::vector<std::string> cameras; ///< empty: the first four
    ivec2 size{640, 480};             ///< pixels
    double time = 0.0;                ///< s
    int frames = 20;                  ///< timed of each setting
    int samples = 96;                 ///< of the reference, through each pixel
    std::filesystem::path out;        ///< empty: standard output
};

struct BudgetCommand {
    SceneArguments scene;
    ViewArguments view;
    reference::ReferenceOptions reference;
    std::string json;
};

struct ExplainCommand {
    SceneArguments scene;
    ViewArguments view;
    std::string json;
};

struct MapsCommand {
    SceneArguments scene;
    std::filesystem::path out; ///< folder
    std::string json;
};

/// What replaces the parts of a PictureTolerance.
struct FolderTolerance {
    std::optional<int> channel, hardLimit;                ///< of 255
    std::optional<double> fraction, hardFraction, mean{}; ///< of the pixels; mean of 255
};

struct CompareCommand {
    std::filesystem::path reference, test; ///< two pictures, or two folders of them
    std::filesystem::path out;             ///< the map of FLIP: .png as colours, .exr as values; empty: none
    std::optional<double> exposure;        ///< of linear pictures; what their header says by default
    std::string toneCurve;                 ///< the same
    double pixelsPerDegree = defaultPixelsPerDegree;
    std::optional<double> maxFlip; ///< fails when the mean is over it
    std::string json;
    // Of two folders:
    std::filesystem::path junit;  ///< file of results for a build server; empty: none
    std::filesystem::path report; ///< folder of a page; empty: none
    FolderTolerance tolerance;
};

struct DisparityCommand {
    SceneArguments scene;
    std::filesystem::path
        reference;             ///< as given to tarn reference: NAME.exr stands for NAME-left.exr and NAME-right.exr
    std::filesystem::path out; ///< map of the error, over the left picture; empty: none
    ShownBy mapped = ShownBy::refraction;
    double scale = 2.0; ///< error of full colour in the map, pixels
    std::string json;
};

struct OptionsCommand {
    std::string json;
    bool markdown = false;
};

struct InfoCommand {
    SceneArguments scene;
    std::string json;
};

/// --help, --version and --describe.
struct PrintCommand {
    std::string text;
};

using Command = std::variant<PrintCommand, ViewCommand, RenderCommand, ReferenceCommand, CompareCommand, BenchCommand,
                             DisparityCommand, TradeCommand, TuneCommand, BudgetCommand, ExplainCommand, MapsCommand,
                             OptionsCommand, InfoCommand>;

/// @param arguments without the program's name. Throws UsageError, with the nearest flag or command for a
/// word that is none.
Command parseCommandLine(const std::vector<std::string>& arguments);

} // namespace tarn
