// Reads one TOML table with errors that name file, line and key. Private to src/scene; the only header with
// toml++.
#pragma once

#include "scene/table_io.h"

#include <toml++/toml.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace tarn {

/// Every key that is asked for counts as known; finish() objects to the others.
class TableReader : public TableIo {
public:
    /// @param section "water", as error messages name it
    TableReader(const toml::table& table, std::string file, std::string section);

    void number(const char* key, float& value, const KeyRange& range) override;
    void integer(const char* key, int& value, const KeyRange& range) override;
    void angle(const char* key, float& radians, const KeyRange& degrees) override;
    void angles(const char* key, vec3& radians) override;
    void vector(const char* key, vec2& value, const KeyRange& range) override;
    void vector(const char* key, vec3& value, const KeyRange& range) override;
    void uniform(const char* key, vec2& value, const KeyRange& range) override;
    void uniform(const char* key, vec3& value, const KeyRange& range) override;
    void flag(const char* key, bool& value) override;
    void text(const char* key, std::string& value) override;
    void path(const char* key, std::filesystem::path& value) override;
    void choiceIndex(const char* key, int& value, std::span<const char* const> names) override;

    /// Null when absent.
    const toml::node* find(const char* key);
    /// A table; null when absent.
    const toml::table* subtable(const char* key);
    /// The tables of an array of tables ([[key]]); none when absent.
    std::vector<const toml::table*> tables(const char* key);

    void require(std::initializer_list<const char*> required);
    /// Throws when the table holds a key that was never asked for.
    void finish() const;

    /// Throws Error "file:line: section.key …" at a key, or at the table when it is absent.
    [[noreturn]] void fail(const char* key, const std::string& problem) const;
    /// "file:line" of the table.
    std::string place() const;
    std::string place(const char* key) const;

private:
    double readNumber(const char* key, const toml::node& node, const KeyRange& range) const;
    template <int N, typename Vector>
    void readVector(const char* key, Vector& value, const KeyRange& range, bool scalarToo);

    const toml::table& table_;
    std::string file_, section_;
    std::vector<std::string> known_;
};

/// "string", "integer" … with its article, as a person would say.
std::string typeName(const toml::node& node);

} // namespace tarn
