// synthetic_report FOLDER [PICTURE...]: a trade of settings whose costs and errors follow from formulas, with its
// report, so that the page can be tested without a reference. Up to three pictures stand for real time, reference,
// FLIP.
#include "base/files.h"
#include "measure/trade/report.h"
#include "measure/trade/runner.h"
#include "synthetic_experiment.h"

#include <cstdio>
#include <exception>

namespace {

using namespace tarn;

class PicturedExperiment : public test::SyntheticExperiment {
public:
    TradePictures files;
    TradePictures pictures(const TradePoint& /*point*/, std::size_t /*view*/) override { return files; }
};

void writeReport(const std::filesystem::path& folder, const std::vector<std::string>& pictures)
{
    TradeSetup setup = test::syntheticSetup({{}, false, loadPresets()});
    setup.about["scene"] = "<b>formulas</b> & \"more\"";
    setup.views = {"overview", "</script><b>shallows</b>"};
    PicturedExperiment experiment;
    if (pictures.size() == 3) experiment.files = {readFile(pictures[0]), readFile(pictures[1]), readFile(pictures[2])};
    TradeStore store(folder, keyOf(setup), true);
    const TradeResults results = runTrade(setup, store, experiment).results;
    const ReportHead head{"A lake <i>of</i> formulas", "25 November 2026", "tarn trade --out \"a folder\" </script>"};
    writeFile(folder / "report.html", tradeReport(setup, results, store, head));
    std::printf("%zu sweeps\n", setup.plan.sweeps.size());
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fputs("synthetic_report: error: a folder is wanted\n", stderr);
        return 2;
    }
    try {
        writeReport(argv[1], {argv + 2, argv + argc});
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "synthetic_report: error: %s\n", error.what());
        return 1;
    }
}
