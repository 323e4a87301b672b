#include "app/command_line.h"

#include "app/command_description.h"
#include "app/parse.h"
#include "app/version.h"
#include "base/error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <tuple>

namespace tarn {

namespace {

constexpr float radiansPerDegree = pi / 180.0f;

/// One command's flags. Text is turned into values by `convert` functions after CLI11 has told flags from
/// arguments, so that every message has the same form.
class Flags {
public:
    explicit Flags(CLI::App& app) : app_(app) {}

    using Convert = std::function<void(const std::string& text, const std::string& flag)>;

    void value(const std::string& flag, const char* what, const char* doc, Convert convert)
    {
        auto text = std::make_shared<std::string>();
        CLI::Option* option = app_.add_option(flag, *text, doc)->type_name(what);
        finally([=] {
            if (option->count() > 0) convert(*text, flag);
        });
    }

    void text(const std::string& flag, const char* what, const char* doc, std::string& value)
    {
        app_.add_option(flag, value, doc)->type_name(what);
    }

    /// A flag whose value may be left out.
    void optionalText(const std::string& flag, const char* what, const char* doc, std::string& value,
                      const char* whenLeftOut)
    {
        CLI::Option* option = app_.add_option(flag, value, doc)->type_name(what)->expected(0, 1);
        finally([option, &value, whenLeftOut] {
            if (option->count() > 0 && value.empty()) value = whenLeftOut;
        });
    }

    /// A flag that may be repeated, one value each.
    void list(const std::string& flag, const char* what, const char* doc, std::vector<std::string>& values)
    {
        app_.add_option(flag, values, doc)->type_name(what)->allow_extra_args(false);
    }

    void toggle(const std::string& flag, const char* doc, bool& value) { app_.add_flag(flag, value, doc); }

    void count(const std::string& flag, const char* doc, int& value, int lower, int upper)
    {
        this->value(flag, "N", doc, [=, &value](const std::string& text, const std::string& name) {
            value = parseCount(text, name, lower, upper);
        });
    }

    void number(const std::string& flag, const char* what, const char* doc, double& value, double lower, double upper)
    {
        this->value(flag, what, doc, [=, &value](const std::string& text, const std::string& name) {
            value = parseNumber(text, name, lower, upper);
        });
    }

    void number(const std::string& flag, const char* what, const char* doc, std::optional<double>& value, double lower,
                double upper)
    {
        this->value(flag, what, doc, [=, &value](const std::string& text, const std::string& name) {
            value = parseNumber(text, name, lower, upper);
        });
    }

    void vector(const std::string& flag, const char* doc, std::optional<vec3>& value)
    {
        this->value(flag, "X,Y,Z", doc,
                    [&value](const std::string& text, const std::string& name) { value = parseVec3(text, name); });
    }

    /// One more thing to do once CLI11 is done.
    void finally(std::function<void()> step) { pending_.push_back(std::move(step)); }

    void convert() const
    {
        for (const auto& step : pending_) step();
    }

private:
    CLI::App& app_;
    std::vector<std::function<void()>> pending_;
};

void addScene(Flags& flags, SceneArguments& scene)
{
    flags.value("SCENE", "FILE", "Scene file (.toml) or model (.obj); the shipped lake by default",
                [&scene](const std::string& text, const std::string&) { scene.file = text; });
    flags.list("--set", "KEY=VALUE", "Set an option, such as refraction.steps=3 (see: tarn options)",
               scene.settings.assignments);
    flags.text("--preset", "NAME",
               "Options that come with Tarn: fast, low, medium, high, best, thesis; auto takes those for the machine",
               scene.settings.preset);
    auto files = std::make_shared<std::vector<std::string>>();
    flags.list("--options", "FILE", "TOML file of options; it wins over --preset, --set over it", *files);
    flags.finally([files, &scene] { scene.settings.files.assign(files->begin(), files->end()); });
    flags.value("--water-level", "M", "Height of the water, m; gives a bare .obj its lake",
                [&scene](const std::string& text, const std::string& flag) {
                    scene.waterLevel = static_cast<float>(parseNumber(text, flag, -1e5, 1e5));
                });
    flags.text("--device", "NAME",
               "What to draw on without a window: part of a name that tarn info lists under devices", scene.device);
}

void addView(Flags& flags, ViewArguments& view)
{
    flags.text("--camera", "NAME", "A camera of the scene; its first by default", view.camera.name);
    flags.vector("--eye", "Where the eye is, m; replaces the camera's", view.camera.eye);
    flags.vector("--target", "The point it looks at, m", view.camera.target);
    flags.vector("--up", "The direction that is up in the picture", view.camera.up);
    flags.value(
        "--fov", "DEG", "Vertical field of view, degrees", [&view](const std::string& text, const std::string& flag) {
            view.camera.verticalFov = static_cast<float>(parseNumber(text, flag, 1.0, 170.0)) * radiansPerDegree;
        });
    flags.value("--size", "WxH", "Size of the picture, pixels",
                [&view](const std::string& text, const std::string& flag) {
                    view.size = parseSize(text, flag);
                    view.sizeGiven = true;
                });
    flags.value("--time", "S", "Time of the waves at the start, s",
                [&view](const std::string& text, const std::string& flag) {
                    view.time = parseNumber(text, flag, -1e6, 1e6);
                    view.timeGiven = true;
                });
}

constexpr auto jsonDoc = "Write the result as JSON to this file; - is standard output";

/// Declares a command's flags; what it returns makes the command once they have their values.
using Define = std::function<Command()> (*)(Flags&);

std::function<Command()> defineView(Flags& flags)
{
    auto command = std::make_shared<ViewCommand>();
    addScene(flags, command->scene);
    addView(flags, command->view);
    flags.toggle("--fullscreen", "Fill the screen", command->fullscreen);
    flags.toggle("--vsync,!--no-vsync", "Wait for the screen's refresh (on by default)", command->vsync);
    flags.count("--frames", "Leave after N frames; 0 stays", command->frames, 0, 1000000);
    flags.number("--fps", "F",
                 "Frames per second to hold by cheaper settings while anything moves (30 by default); 0 shows "
                 "your settings whatever they take",
                 command->fps, 0.0, 1000.0);
    flags.value("--ladder", "FILE",
                "Settings to hold it by, from tarn trade --write-ladder; the shipped ones by default",
                [command = command.get()](const std::string& text, const std::string&) { command->ladder = text; });
    flags.value("--reference", "FILE", "A picture of `tarn reference` to see beside the live one",
                [command = command.get()](const std::string& text, const std::string&) { command->reference = text; });
    return [command] { return *command; };
}

DebugView parseDebugView(const std::string& text, const std::string& flag)
{
    if (const auto view = debugViewFromName(text)) return *view;
    const std::vector<std::string> names(debugViewNames.begin(), debugViewNames.end());
    throw UsageError("{} {}: no such view; there are {}", flag, text, fmt::join(names, ", "));
}

ErrorKind parseErrorKind(const std::string& text, const std::string& flag)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < errorKinds.size(); ++i) {
        if (text == errorKinds[i].name) return static_cast<ErrorKind>(i);
        names.emplace_back(errorKinds[i].name);
    }
    throw UsageError("{} {}: no such error; there are {}", flag, text, fmt::join(names, ", "));
}

void addErrorMap(Flags& flags, RenderCommand& c)
{
    flags.value("--error", "KIND",
                "A map of what the water has wrong: refraction, reflection, fresnel, path or caustics",
                [&c](const std::string& text, const std::string& flag) { c.error = parseErrorKind(text, flag); });
    flags.value("--reference", "FILE", "What --error compares with; gives camera, time and size",
                [&c](const std::string& text, const std::string&) { c.reference = text; });
    flags.number("--error-scale", "X", "Error that --error shows in full colour, in m, degrees or as a fraction",
                 c.errorScale, 1e-9, 1e9);
}

void requireMeaning(const RenderCommand& c)
{
    if (!c.error && !c.reference.empty())
        throw UsageError("--reference is for --error; name one, such as --error path");
    if (!c.error && c.errorScale > 0.0)
        throw UsageError("--error-scale is for --error; name one, such as --error path");
    if (!c.error) return;
    if (c.reference.empty())
        throw UsageError("--error needs --reference FILE; make one with: tarn reference --out truth.exr");
    if (c.frames > 1 || c.allCameras || c.debugView != DebugView::final)
        throw UsageError("--error makes one map; leave --frames, --all-cameras and --view away");
}

std::function<Command()> defineRender(Flags& flags)
{
    auto command = std::make_shared<RenderCommand>();
    RenderCommand& c = *command;
    c.view.size = {1024, 768};
    addScene(flags, c.scene);
    addView(flags, c.view);
    flags.value("--view", "NAME", "Show an intermediate picture: fresnel, path-length, …",
                [&c](const std::string& text, const std::string& flag) { c.debugView = parseDebugView(text, flag); });
    flags.text("--out", "FILE", "Picture: .png tone-mapped, .exr linear; name_%04d.png for a sequence", c.out);
    flags.count("--frames", "Pictures in the sequence", c.frames, 1, 1000000);
    flags.number("--fps", "F", "Pictures per second of the sequence", c.fps, 1e-3, 1e4);
    flags.toggle("--all-cameras", "A picture from each camera; --out names their folder", c.allCameras);
    flags.toggle("--check", "Fail when a pass makes NaN, infinity or negative radiance", c.check);
    addErrorMap(flags, c);
    flags.text("--json", "FILE", jsonDoc, c.json);
    return [command]() -> Command {
        if (command->out.empty()) throw UsageError("render needs --out FILE, such as --out lake.png");
        if (command->allCameras && command->frames > 1)
            throw UsageError("--all-cameras makes one picture each; leave --frames away");
        if (command->allCameras && !command->view.camera.name.empty())
            throw UsageError("--all-cameras renders every camera; leave --camera away");
        requireMeaning(*command);
        return *command;
    };
}

std::function<Command()> defineReference(Flags& flags)
{
    auto command = std::make_shared<ReferenceCommand>();
    ReferenceCommand& c = *command;
    c.view.size = {640, 480};
    addScene(flags, c.scene);
    addView(flags, c.view);
    flags.text("--out", "FILE", "Picture: .exr with every channel, .png as it would be shown", c.out);
    flags.count("--samples", "Paths through each pixel", c.reference.samples, 1, 65536);
    flags.count("--depth", "Meetings with the water's surface that a path follows", c.reference.depth, 1, 16);
    flags.count("--bounces", "Diffuse reflections of light between bed, objects and surface", c.reference.bounces, 0,
                64);
    flags.count("--photons", "Photons that find the sun's light under water", c.reference.photons, 10'000,
                2'000'000'000);
    flags.count("--seed", "Of all random numbers", c.reference.seed, 0, 2'000'000'000);
    auto half = std::make_shared<bool>(false);
    flags.toggle("--half", "Half the size, a quarter of the samples and photons: a quick look", *half);
    flags.text("--json", "FILE", jsonDoc, c.json);
    return [command, half]() -> Command {
        if (command->out.empty()) throw UsageError("reference needs --out FILE, such as --out truth.exr");
        ReferenceCommand result = *command;
        if (*half) {
            result.view.size = glm::max(result.view.size / 2, ivec2(1));
            result.reference.samples = std::max(result.reference.samples / 4, 1);
            result.reference.photons = std::max(result.reference.photons / 4, 10'000);
        }
        return result;
    };
}

std::function<Command()> defineBench(Flags& flags)
{
    auto command = std::make_shared<BenchCommand>();
    command->view.size = {1024, 768};
    addScene(flags, command->scene);
    addView(flags, command->view);
    flags.count("--frames", "Frames measured of each configuration", command->frames, 1, 1000000);
    flags.count("--warm-up", "Frames drawn first and not counted", command->warmUp, 0, 10000);
    flags.list("--vary", "KEY=VALUE", "Measure one more configuration, with this option set", command->variants);
    flags.toggle("--flight",
                 "Fly past the scene's cameras, from the first to the last, in the frames that are measured",
                 command->flight);
    flags.toggle("--yardstick",
                 "Measure one plain pass of 100,352 textured triangles at 1024x768 too, and tell all else in it",
                 command->yardstick);
    flags.toggle("--rules", "Measure the frame plan: without each rule that applies, and without all of them",
                 command->rules);
    flags.toggle("--interactive",
                 "Fly past the scene's cameras at real speed: times of frames, and from input to picture",
                 command->interactive);
    flags.number("--seconds", "S", "Length of the flight of --interactive, s", command->seconds, 0.1, 3600.0);
    flags.value("--table", "N", "Measure table 2 or 3 of Mihalik 2008, chapter 10, beside its figures",
                [command = command.get()](const std::string& text, const std::string& flag) {
                    command->table = &findPaperTable(text, flag);
                });
    flags.toggle(
        "--startup",
        "Measure when this process, since it began, has its scene, its first picture and all its programs; with "
        "MESA_SHADER_CACHE_DIR set to an empty folder that is a first start",
        command->startup);
    flags.text("--json", "FILE", jsonDoc, command->json);
    return [command] {
        if (command->interactive &&
            (command->table || command->flight || command->rules || command->yardstick || !command->variants.empty()))
            throw UsageError("--interactive has a flight of its own; leave --table, --flight, --rules, --yardstick and "
                             "--vary away");
        if (command->startup && (command->table || command->flight || command->rules || command->yardstick ||
                                 command->interactive || !command->variants.empty()))
            throw UsageError(
                "--startup measures one start; leave --table, --flight, --rules, --yardstick, --interactive and "
                "--vary away");
        if (command->table && !command->variants.empty())
            throw UsageError("--table has configurations of its own; leave --vary away");
        if (command->table && (command->flight || command->rules))
            throw UsageError("--table has a view and configurations of its own; leave --flight and --rules away");
        return *command;
    };
}

std::function<Command()> defineTrade(Flags& flags)
{
    auto command = std::make_shared<TradeCommand>();
    TradeCommand& c = *command;
    addScene(flags, c.scene);
    flags.value("--out", "DIR", "Folder of the results, the tables and report.html; made when it is not there",
                [&c](const std::string& text, const std::string&) { c.out = text; });
    flags.list("--sweep", "KEY=VALUES",
               "Sweep an option: 1:8, 1:64:*2, 0:1:0.25 or a,b,c, and a,b@OTHER=c while another is set; a plan of "
               "its own by default",
               c.sweeps);
    flags.toggle("--grid", "Every combination of the sweeps, instead of one option at a time", c.grid);
    flags.toggle("--presets-only", "Measure the options as given and the presets, and sweep nothing", c.presetsOnly);
    flags.value("--views", "NAMES", "Cameras, a,b,c; the scene's first eight by default",
                [&c](const std::string& text, const std::string& flag) { c.views = parseNames(text, flag); });
    flags.value("--times", "S,S",
                "Times of the waves, s, all of them in each view; by default the views take turns at 0 and 1.7",
                [&c](const std::string& text, const std::string& flag) { c.times = parseNumbers(text, flag); });
    flags.value("--size", "WxH", "Size of the pictures, pixels",
                [&c](const std::string& text, const std::string& flag) { c.size = parseSize(text, flag); });
    flags.count("--frames", "Frames timed of each setting", c.frames, 1, 100000);
    flags.count("--samples", "Paths through each pixel of the reference", c.samples, 1, 65536);
    flags.value("--shard", "I/N", "Measure only part I of N; --merge puts the parts together",
                [&c](const std::string& text, const std::string& flag) {
                    std::tie(c.shard, c.shards) = parseShard(text, flag);
                });
    auto merge = std::make_shared<std::vector<std::string>>();
    flags.list("--merge", "DIR", "Put another folder's results into --out and measure nothing; may be repeated",
               *merge);
    flags.toggle("--fresh", "Throw the results in --out away and start anew", c.fresh);
    flags.value("--write-presets", "DIR",
                "Write fast, low, medium, high and best.toml, picked from the front; with --write-ladder fast.toml",
                [&c](const std::string& text, const std::string&) { c.writePresets = text; });
    flags.value("--write-ladder", "FILE",
                "Measure what is cheaper than the settings, and write the front as a ladder for the viewer's governor",
                [&c](const std::string& text, const std::string&) { c.writeLadder = text; });
    flags.finally([merge, &c] { c.merge.assign(merge->begin(), merge->end()); });
    return [command]() -> Command {
        if (command->out.empty()) throw UsageError("trade needs --out DIR, a folder for its results");
        if (!command->writeLadder.empty() && (!command->sweeps.empty() || command->grid || command->presetsOnly))
            throw UsageError("--write-ladder has a plan of its own; leave --sweep, --grid and --presets-only away");
        if (command->shards > 1 && !command->writeLadder.empty())
            throw UsageError("--shard measures a part only; leave --write-ladder away");
        if (command->shards > 1 && (!command->merge.empty() || !command->writePresets.empty()))
            throw UsageError("--shard measures a part only; leave --merge and --write-presets away");
        return *command;
    };
}

std::function<Command()> defineTune(Flags& flags)
{
    auto command = std::make_shared<TuneCommand>();
    TuneCommand& c = *command;
    addScene(flags, c.scene);
    flags.value(
        "--max-error", "FLIP", "The cheapest settings with at most this mean FLIP",
        [&c](const std::string& text, const std::string& flag) { c.maxError = parseNumber(text, flag, 0.0, 1.0); });
    flags.value(
        "--budget-ms", "MS", "The most accurate settings within so many milliseconds a frame",
        [&c](const std::string& text, const std::string& flag) { c.budgetMs = parseNumber(text, flag, 1e-3, 1e6); });
    flags.list("--camera", "NAME", "A camera to tune for; may be repeated; the scene's first four by default",
               c.cameras);
    flags.value("--size", "WxH", "Size of the picture, pixels",
                [&c](const std::string& text, const std::string& flag) { c.size = parseSize(text, flag); });
    flags.number("--time", "S", "Time of the waves, s", c.time, -1e6, 1e6);
    flags.count("--frames", "Frames timed of each setting", c.frames, 1, 100000);
    flags.count("--samples", "Paths through each pixel of the reference", c.samples, 1, 65536);
    flags.value("--out", "FILE", "A file for --options; standard output by default",
                [&c](const std::string& text, const std::string&) { c.out = text; });
    return [command]() -> Command {
        if (command->maxError.has_value() == command->budgetMs.has_value())
            throw UsageError("tune needs one goal: --max-error FLIP or --budget-ms MS");
        return *command;
    };
}

std::function<Command()> defineBudget(Flags& flags)
{
    auto command = std::make_shared<BudgetCommand>();
    BudgetCommand& c = *command;
    c.view.size = {320, 240};
    c.reference.samples = 32;
    c.reference.photons = 4'000'000; // traced anew for every part that bends light
    addScene(flags, c.scene);
    addView(flags, c.view);
    flags.count("--samples", "Paths through each pixel of the reference", c.reference.samples, 1, 65536);
    flags.count("--photons", "Photons that find the sun's light under water", c.reference.photons, 10'000,
                2'000'000'000);
    flags.text("--json", "FILE", jsonDoc, c.json);
    return [command] { return *command; };
}

std::function<Command()> defineExplain(Flags& flags)
{
    auto command = std::make_shared<ExplainCommand>();
    command->view.size = {1024, 768};
    addScene(flags, command->scene);
    addView(flags, command->view);
    flags.text("--json", "FILE", jsonDoc, command->json);
    return [command] { return *command; };
}

std::function<Command()> defineMaps(Flags& flags)
{
    auto command = std::make_shared<MapsCommand>();
    addScene(flags, command->scene);
    flags.value("--out", "DIR", "Folder of bed.exr and above_water.exr; made when it is not there",
                [command = command.get()](const std::string& text, const std::string&) { command->out = text; });
    flags.text("--json", "FILE", jsonDoc, command->json);
    return [command]() -> Command {
        if (command->out.empty()) throw UsageError("maps needs --out DIR, a folder for bed.exr and above_water.exr");
        return *command;
    };
}

std::string parseToneCurve(const std::string& text, const std::string& flag)
{
    Options options; // the option's own check, so that its names stand in one place
    assign([&](FieldVisitor& visitor) { visit(visitor, options); }, {"frame.tone_curve", text, flag});
    return text;
}

std::function<Command()> defineCompare(Flags& flags)
{
    auto command = std::make_shared<CompareCommand>();
    CompareCommand& c = *command;
    flags.value("REFERENCE", "FILE", "The picture that is right: .png, .jpg, or .exr (linear)",
                [&c](const std::string& text, const std::string&) { c.reference = text; });
    flags.value("TEST", "FILE", "The picture to judge, of the same size",
                [&c](const std::string& text, const std::string&) { c.test = text; });
    flags.value("--out", "FILE", "Map of the differences seen: .png as colours, .exr as FLIP's values",
                [&c](const std::string& text, const std::string&) { c.out = text; });
    flags.number("--exposure", "E", "Factor on linear pictures; the reference's own by default", c.exposure, 0.0,
                 1000.0);
    flags.value("--tone-curve", "NAME", "linear, reinhard or aces; the reference's own by default",
                [&c](const std::string& text, const std::string& flag) { c.toneCurve = parseToneCurve(text, flag); });
    flags.number("--ppd", "P", "Pixels that fill a degree of the viewer's sight", c.pixelsPerDegree,
                 leastPixelsPerDegree, mostPixelsPerDegree);
    flags.number("--max-flip", "X", "Fail when the mean FLIP is over X", c.maxFlip, 0.0, 1.0);
    flags.text("--json", "FILE", jsonDoc, c.json);
    return [command]() -> Command {
        if (command->test.empty())
            throw UsageError("compare needs two pictures, such as compare reference.png test.png");
        return *command;
    };
}

std::function<Command()> defineDisparity(Flags& flags)
{
    auto command = std::make_shared<DisparityCommand>();
    DisparityCommand& c = *command;
    addScene(flags, c.scene);
    flags.value("--reference", "FILE", "NAME.exr, for the pair NAME-left.exr and NAME-right.exr of tarn reference",
                [&c](const std::string& text, const std::string&) { c.reference = text; });
    flags.value("--out", "FILE", "Map of the error over the left picture: .png as colours, .exr as pixels",
                [&c](const std::string& text, const std::string&) { c.out = text; });
    flags.value("--of", "WAY", "What the map shows: refraction (by default) or reflection",
                [&c](const std::string& text, const std::string& flag) {
                    const auto found = std::find(shownByNames.begin(), shownByNames.end(), text);
                    if (found == shownByNames.end())
                        throw UsageError("{} {}: no such way; there are {}", flag, text, fmt::join(shownByNames, ", "));
                    c.mapped = static_cast<ShownBy>(found - shownByNames.begin());
                });
    flags.number("--scale", "PX", "Error that the map shows in full colour, pixels", c.scale, 1e-6, 1e6);
    flags.text("--json", "FILE", jsonDoc, c.json);
    return [command]() -> Command {
        if (command->reference.empty())
            throw UsageError("disparity needs --reference FILE; make the pair with: tarn reference --set "
                             "stereo.output=pair --out truth.exr");
        return *command;
    };
}

std::function<Command()> defineOptions(Flags& flags)
{
    auto command = std::make_shared<OptionsCommand>();
    flags.optionalText("--json", "FILE", "As JSON, to this file or to standard output", command->json, "-");
    flags.toggle("--markdown", "As tables in Markdown, one for each group", command->markdown);
    return [command]() -> Command {
        if (command->markdown && !command->json.empty())
            throw UsageError("--markdown or --json: options writes one of them");
        return *command;
    };
}

std::function<Command()> defineInfo(Flags& flags)
{
    auto command = std::make_shared<InfoCommand>();
    addScene(flags, command->scene);
    flags.text("--json", "FILE", jsonDoc, command->json);
    return [command] { return *command; };
}

struct CommandRow {
    const char* name;
    const char* doc;
    Define define;
};

constexpr CommandRow commands[] = {
    {"view", "Walk round the lake in a window (the default)", defineView},
    {"render", "Write pictures", defineRender},
    {"reference", "Trace the true picture, and what the water hides in it", defineReference},
    {"bench", "Measure what a frame and its passes cost, with the water and without", defineBench},
    {"trade", "Measure what options cost in time and in accuracy, and write a report", defineTrade},
    {"tune", "Find the settings that keep a limit of error or of time on this machine", defineTune},
    {"budget", "Say which part of a picture's error each approximation owns", defineBudget},
    {"explain", "Say which passes a frame runs, and why", defineExplain},
    {"maps", "Write the maps of heights that rays are marched through, as pictures", defineMaps},
    {"compare", "Say how different two pictures are, to the eye and in their values", defineCompare},
    {"disparity", "Say how far a drawn pair's disparity is from the reference's pair", defineDisparity},
    {"options", "List every option", defineOptions},
    {"info", "Say what this program, machine and scene are", defineInfo},
};

bool isCommand(const std::string& word)
{
    return std::any_of(std::begin(commands), std::end(commands),
                       [&](const CommandRow& row) { return word == row.name; });
}

/// Puts the default command in front where none is named. A lone word that is neither a command nor a file
/// nor looks like one is taken for a misspelt command.
std::vector<std::string> withCommand(std::vector<std::string> arguments)
{
    if (!arguments.empty()) {
        const std::string& first = arguments.front();
        if (isCommand(first) || first == "--help" || first == "-h" || first == "--version" || first == "--describe")
            return arguments;
        const bool looksLikeFile = first.find_first_of("./-") != std::string::npos;
        if (!looksLikeFile && !std::filesystem::exists(first)) {
            std::vector<std::string> names;
            for (const CommandRow& row : commands) names.emplace_back(row.name);
            const std::string near = nearestName(first, names);
            throw UsageError("{}: no such command or scene; {}", first,
                             near.empty() ? fmt::format("there are {}", fmt::join(names, ", "))
                                          : fmt::format("did you mean {}?", near));
        }
    }
    arguments.insert(arguments.begin(), "view");
    return arguments;
}

std::string unknownFlagMessage(const CLI::App& app)
{
    const std::string word = app.remaining(true).front();
    if (word.empty() || word.front() != '-') return fmt::format("{}: one argument too many; see --help", word);
    const std::string flag = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands())
        for (const CLI::Option* option : command->get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    const std::string near = nearestName(flag, names);
    return fmt::format("{}: no such flag{}; see --help", flag,
                       near.empty() ? "" : fmt::format(", did you mean {}?", near));
}

} // namespace

Command parseCommandLine(const std::vector<std::string>& arguments)
{
    CLI::App app{"Tarn shows lakes, and knows what its speed costs in accuracy.", "tarn"};
    app.require_subcommand(1);
    app.set_version_flag("--version", fmt::format("tarn {} ({})", versionText(), buildText()));

    std::vector<std::string> words = withCommand(arguments);
    struct Declared {
        std::unique_ptr<Flags> flags;
        std::function<Command()> make;
    };
    std::map<std::string, Declared> declared; // CLI11 keeps pointers into all of them
    for (const CommandRow& row : commands) {
        auto flags = std::make_unique<Flags>(*app.add_subcommand(row.name, row.doc));
        std::function<Command()> make = row.define(*flags);
        declared[row.name] = {std::move(flags), std::move(make)};
    }
    const std::string name = words.front();
    if (name == "--describe") {
        if (words.size() > 1) throw UsageError("{}: one argument too many; --describe stands alone", words[1]);
        return PrintCommand{describeCommandLine(app)};
    }

    std::reverse(words.begin(), words.end()); // as CLI11 wants them
    try {
        app.parse(std::move(words));
    } catch (const CLI::CallForHelp&) {
        return PrintCommand{app.help()};
    } catch (const CLI::CallForVersion& version) {
        return PrintCommand{std::string(version.what()) + "\n"};
    } catch (const CLI::ExtrasError&) {
        throw UsageError("{}", unknownFlagMessage(app));
    } catch (const CLI::ParseError& error) {
        throw UsageError("{}; see --help", error.what());
    }
    const Declared& chosen = declared.at(name);
    chosen.flags->convert();
    Command command = chosen.make();
    if (auto* trade = std::get_if<TradeCommand>(&command))
        trade->commandLine = fmt::format("tarn {}", fmt::join(arguments, " "));
    return command;
}

} // namespace tarn
