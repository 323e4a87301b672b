#include "measure/trade/store.h"

#include "base/error.h"
#include "base/files.h"

#include <nlohmann/json.hpp>

namespace tarn {

namespace fs = std::filesystem;

namespace {

constexpr auto keyFile = "trade.json";

/// Long values (settings, plans) are not for a message of one line.
std::string shown(const std::string& value) { return value.size() <= 60 ? fmt::format("'{}'", value) : "another"; }

void requireSameKey(const fs::path& folder, const TradeKey& there, const TradeKey& wanted, const char* advice)
{
    for (const auto& [name, value] : wanted) {
        const auto found = there.find(name);
        if (found == there.end())
            throw Error("{}: its results do not tell their {}; {}", folder.string(), name, advice);
        if (found->second != value)
            throw Error("{}: its results are of {} {}, not {}; {}", folder.string(), shown(found->second), name,
                        shown(value), advice);
    }
}

} // namespace

TradeKey readTradeKey(const fs::path& folder)
{
    const fs::path file = folder / keyFile;
    if (!fs::exists(file)) throw Error("{}: holds no results of tarn trade", folder.string());
    try {
        return nlohmann::json::parse(readFile(file)).get<TradeKey>();
    } catch (const nlohmann::json::exception&) {
        throw Error("{}: damaged; start anew with --fresh", file.string());
    }
}

TradeStore::TradeStore(fs::path folder, const TradeKey& key, bool fresh) : folder_(std::move(folder)), key_(key)
{
    makeFolder(folder_);
    if (fresh) {
        std::error_code ignored;
        for (const char* made : {"results", "references"}) fs::remove_all(folder_ / made, ignored);
        fs::remove(folder_ / keyFile, ignored);
    }
    makeFolder(folder_ / "results");
    if (fs::exists(folder_ / keyFile)) {
        requireSameKey(folder_, readTradeKey(folder_), key_, "give another --out, or --fresh to start anew");
    } else {
        writeFile(folder_ / keyFile, nlohmann::json(key_).dump(1) + "\n");
    }
}

fs::path TradeStore::path(const std::string& name) const { return folder_ / "results" / name; }

bool TradeStore::has(const std::string& name) const { return fs::exists(path(name)); }

std::string TradeStore::read(const std::string& name) const { return readFile(path(name)); }

void TradeStore::write(const std::string& name, const std::string& bytes) { writeFile(path(name), bytes); }

nlohmann::json TradeStore::readJson(const std::string& name) const
{
    try {
        return nlohmann::json::parse(read(name));
    } catch (const nlohmann::json::exception&) {
        throw Error("{}: damaged; delete it and run again", path(name).string());
    }
}

void TradeStore::writeJson(const std::string& name, const nlohmann::json& json)
{
    write(name, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void TradeStore::merge(const std::vector<fs::path>& others)
{
    for (const fs::path& other : others)
        requireSameKey(other, readTradeKey(other), key_, "only shards of one trade can be merged");
    for (const fs::path& other : others) {
        if (!fs::exists(other / "results")) continue;
        for (const fs::directory_entry& entry : fs::directory_iterator(other / "results")) {
            const std::string name = entry.path().filename().string();
            const bool isResult = entry.path().extension() == ".json" || entry.path().extension() == ".png";
            if (isResult && !has(name)) write(name, readFile(entry.path()));
        }
    }
}

} // namespace tarn
