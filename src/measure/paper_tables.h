// The tables of Mihálik 2008, chapter 10, measured on this machine and set beside the thesis' own figures.
//
// Its cards are of 2004 to 2006, so that frames per second compare with nothing of today. What compares is
// how much of the frame rate an effect takes: the ratio of two rows of a table.
#pragma once

#include "measure/benchmark.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tarn {

/// A graphics card of the thesis.
struct PaperCard {
    std::string name;
    std::vector<double> framesPerSecond; ///< one for each row of the table
};

struct PaperRow {
    std::string name;
    std::vector<std::string> assignments; ///< "key=value": what makes this row's configuration
};

struct PaperTable {
    int number = 0; ///< in the thesis
    std::string title;
    std::vector<PaperRow> rows;
    std::size_t base = 0; ///< the row that ratios are against
    std::vector<PaperCard> cards;
};

std::span<const PaperTable> paperTables();

/// @param number as a person writes it. Throws UsageError that names the flag and the tables there are.
const PaperTable& findPaperTable(std::string_view number, std::string_view flag);

/// @param report its results are the table's rows, in their order; throws Error when there are more or fewer
/// The benchmark's JSON, with the table in place of the ratios against the last configuration.
nlohmann::json toJson(const PaperTable& table, const BenchReport& report);
/// For people: the machine, the table beside the thesis' figures, and the median of each pass.
std::string toMarkdown(const PaperTable& table, const BenchReport& report);

} // namespace tarn
