#include "app/compared_picture.h"

#include "base/error.h"
#include "base/log.h"
#include "measure/display.h"
#include "measure/picture_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>

namespace tarn {

bool isLinearFile(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".exr" || extension == ".hdr";
}

namespace {

/// R, G and B of a picture that may hold more: a reference has the water's geometry beside them.
Image colourChannels(const NamedImage& picture)
{
    const Image& all = picture.image;
    std::array<std::size_t, 3> places{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::string name(1, "RGB"[i]);
        const auto found = std::find(picture.channelNames.begin(), picture.channelNames.end(), name);
        if (found == picture.channelNames.end())
            throw Error("{}: has no channel {}; it has {}", all.name, name, fmt::join(picture.channelNames, ", "));
        places[i] = static_cast<std::size_t>(found - picture.channelNames.begin());
    }
    Image result{all.name, all.width, all.height, 3, {}, {}};
    result.floats.reserve(result.size());
    for (std::size_t i = 0; i < all.floats.size(); i += picture.channelNames.size())
        for (const std::size_t place : places) result.floats.push_back(all.floats[i + place]);
    return result;
}

void assignFrame(FrameOptions& frame, const Assignment& assignment)
{
    Options options;
    options.frame = frame;
    assign([&](FieldVisitor& visitor) { visit(visitor, options); }, assignment);
    frame = options.frame;
}

/// What the header says of exposure and tone curve replaces the defaults. A damaged header is an error: to
/// compare with a guessed exposure would give a wrong figure without a word.
Showing headerShowing(const ComparedPicture& source)
{
    Showing showing;
    if (source.settings.empty()) return showing;
    const std::string name = source.file.string();
    const auto json = nlohmann::json::parse(source.settings, nullptr, false);
    if (!json.is_object()) throw Error("{}: its tarn:settings are damaged; give --exposure and --tone-curve", name);
    if (!json.contains("frame") || !json["frame"].is_object()) return showing;
    const auto take = [&](const char* key, std::string& origin) {
        if (!json["frame"].contains(key)) return;
        const nlohmann::json& value = json["frame"][key];
        const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
        try {
            assignFrame(showing.frame, {fmt::format("frame.{}", key), text, name});
        } catch (const UsageError& error) { // the file's mistake, not the command line's
            throw Error("{}", error.what());
        }
        origin = "from " + name;
    };
    take("exposure", showing.exposureOrigin);
    take("tone_curve", showing.toneCurveOrigin);
    return showing;
}

} // namespace

ComparedPicture readComparedPicture(const std::filesystem::path& file)
{
    if (!isLinearFile(file)) {
        ComparedPicture source{file, readImage(file), false, ""};
        if (source.image.isFloat())
            throw Error("{}: has more than 8 bits; 8-bit pictures and linear .exr files are compared", file.string());
        return source;
    }
    const NamedImage picture = readNamedImage(file);
    const auto settings = picture.metadata.find("tarn:settings");
    ComparedPicture source{file, colourChannels(picture), true,
                           settings == picture.metadata.end() ? "" : settings->second};
    requireFinite(source.image);
    return source;
}

Showing chooseShowing(const CompareCommand& command, const ComparedPicture& reference, const ComparedPicture& test)
{
    Showing showing;
    if (!command.exposure || command.toneCurve.empty()) {
        const bool fromReference = !reference.settings.empty();
        showing = headerShowing(fromReference ? reference : test);
        if (fromReference && !test.settings.empty()) {
            const FrameOptions other = headerShowing(test).frame;
            if (other.exposure != showing.frame.exposure || other.toneCurve != showing.frame.toneCurve)
                log::warning("{} was made with another exposure or tone curve than {}; the latter's are used",
                             test.file.string(), reference.file.string());
        }
    }
    if (command.exposure) {
        showing.frame.exposure = static_cast<float>(*command.exposure);
        showing.exposureOrigin = "--exposure";
    }
    if (!command.toneCurve.empty()) {
        assignFrame(showing.frame, {"frame.tone_curve", command.toneCurve, "--tone-curve"});
        showing.toneCurveOrigin = "--tone-curve";
    }
    return showing;
}

Image exposed(const ComparedPicture& picture, const Showing& showing)
{
    return picture.isLinear ? exposedPicture(picture.image, showing.frame.exposure) : picture.image;
}

Image shown(const ComparedPicture& picture, const Image& exposed, const Showing& showing)
{
    return picture.isLinear ? displayPicture(exposed, showing.frame.toneCurve) : exposed;
}

nlohmann::json frameJson(const FrameOptions& frame)
{
    Options options;
    options.frame = frame;
    return toJson([&](FieldVisitor& visitor) { visit(visitor, options); })["frame"];
}

} // namespace tarn
