// tarn budget: which part of a picture's error each approximation of the frame owns.
#include "app/command_flags.h"
#include "app/commands.h"
#include "app/error_budget.h"
#include "app/scene_setup.h"
#include "base/error.h"
#include "measure/trade/trade_json.h"

#include <nlohmann/json.hpp>

namespace tarn {

void run(const BudgetCommand& command)
{
    requireWritableJson(command.json);
    TerminalProgress progress;
    const SceneSetup sceneSetup = loadSceneSetup(command.scene, &progress);
    const Camera camera = chooseCamera(sceneSetup.scene, command.view.camera);
    const Settings& settings = sceneSetup.settings;
    requireOneEye(settings, "errors are measured in one eye's picture");
    if (!settings.water.present || !settings.options.water.enabled)
        throw Error("{}: has no water, and so none of the errors that a budget parts", sceneSetup.scene.file.string());

    Session session(sceneSetup, command.view.size, &progress);
    const reference::Tracer tracer(sceneSetup.scene, settings.water, settings.options.water.sunSlopeDeviation);
    const ErrorBudget budget = measureBudget({.scene = sceneSetup.scene,
                                              .settings = settings,
                                              .camera = camera,
                                              .time = command.view.time,
                                              .size = command.view.size,
                                              .reference = command.reference,
                                              .truth = nullptr},
                                             session, tracer, &progress);

    nlohmann::json json = toJson(budget);
    json["scene"] = sceneSetup.scene.file.string();
    json["camera"] = camera.name;
    json["time"] = command.view.time;
    json["size"] = {command.view.size.x, command.view.size.y};
    json["samples"] = command.reference.samples;
    json["photons"] = command.reference.photons;
    json["settings"] = nlohmann::json::parse(settingsJson(settings));
    writeJson(command.json, json);
    if (command.json == "-") return;
    fmt::print("{} at {} s, {}x{} pixels, reference of {} samples\n{}", camera.name, command.view.time,
               command.view.size.x, command.view.size.y, command.reference.samples, budgetTable(budget));
}

MakeCommand defineBudget(Flags& flags)
{
    auto command = std::make_shared<BudgetCommand>();
    BudgetCommand& c = *command;
    c.view.size = {320, 240};
    c.reference.samples = 32;
    c.reference.photons = 4'000'000; // traced anew for every part that bends light
    addSceneFlags(flags, c.scene);
    addViewFlags(flags, c.view);
    flags.count("--samples", "Paths through each pixel of the reference", c.reference.samples, 1, 65536);
    flags.count("--photons", "Photons that find the sun's light under water", c.reference.photons, 10'000,
                2'000'000'000);
    flags.json(c.json);
    return [command] { return *command; };
}

} // namespace tarn
