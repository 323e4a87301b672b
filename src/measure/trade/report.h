// report.html: a trade as one page that a person reads. It needs no other file and no network.
//
// The page's text, style and script are assets/report/*; its plots are Chart.js, read from where the
// distribution installs it. The script tells how it went: <html data-plots="N"> once N plots are drawn,
// data-error when it failed.
#pragma once

#include "measure/trade/results.h"

#include <string>

namespace tarn {

struct ReportHead {
    std::string title;   ///< the scene's name
    std::string date;    ///< "25 November 2026"
    std::string command; ///< the command line
};

/// Throws Error when Chart.js or the page's parts are not installed, or a stored picture is unreadable.
std::string tradeReport(const TradeSetup& setup, const TradeResults& results, const TradeStore& store,
                        const ReportHead& head);

/// Throws Error when tradeReport could not write a page; call before long work.
void requireReportParts();

/// JSON that may stand inside <script>: no "</script>" can close it early.
std::string scriptJson(const nlohmann::json& json);

} // namespace tarn
