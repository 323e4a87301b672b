// A folder of finished measurements. Each is a file that appears whole or not at all, so that a run which is
// cut short, by Ctrl-C or by the power, loses no more than what it was at.
//
//     DIR/trade.json         what the measurements hold for: the key
//     DIR/results/NAME.json  one measurement each
//     DIR/results/NAME.png   pictures
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tarn {

/// What measurements must have in common to stand in one folder: "scene", "size", "version" …
using TradeKey = std::map<std::string, std::string>;

class TradeStore {
public:
    /// Opens the folder, or makes it. With `fresh`, older measurements and references in it are removed. Throws Error
    /// when it holds measurements under another key, saying what differs, or when it cannot be written.
    TradeStore(std::filesystem::path folder, const TradeKey& key, bool fresh);

    const std::filesystem::path& folder() const { return folder_; }

    /// @param name with its extension
    bool has(const std::string& name) const;
    std::string read(const std::string& name) const;
    void write(const std::string& name, const std::string& bytes);

    /// Throws Error naming the file when it is damaged.
    nlohmann::json readJson(const std::string& name) const;
    void writeJson(const std::string& name, const nlohmann::json& json);

    /// Copies what the other folders hold and this one lacks. Throws Error when one was made under another
    /// key.
    void merge(const std::vector<std::filesystem::path>& others);

private:
    std::filesystem::path path(const std::string& name) const;

    std::filesystem::path folder_;
    TradeKey key_;
};

/// The key of a folder that trade wrote. Throws Error when there is none.
TradeKey readTradeKey(const std::filesystem::path& folder);

} // namespace tarn
