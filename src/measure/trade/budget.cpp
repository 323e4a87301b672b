#include "measure/trade/budget.h"

#include <fmt/format.h>

#include <cmath>

namespace tarn {

double sumOfParts(const ErrorBudget& budget, double ErrorBudget::Row::*figure)
{
    double sum = ErrorBudget::none;
    for (const ErrorBudget::Row& row : budget.rows)
        if (const double value = row.*figure; std::isfinite(value)) sum = std::isfinite(sum) ? sum + value : value;
    return sum;
}

namespace {

std::string figureText(double value) { return std::isfinite(value) ? fmt::format("{:.4f}", value) : "-"; }

std::string line(const std::string& what, const std::string& alone, const std::string& removed,
                 const std::string& remark = "")
{
    const std::string text = fmt::format("  {:<34}{:>9}{:>11}", what, alone, removed);
    return remark.empty() ? text + "\n" : fmt::format("{}  {}\n", text, remark);
}

} // namespace

std::string budgetTable(const ErrorBudget& budget)
{
    using Row = ErrorBudget::Row;
    std::string text = line(budget.quantity, "alone", "taken out", "exact is");
    for (const Row& row : budget.rows)
        text += line(row.part, figureText(row.alone), figureText(row.removed), row.exact);
    text += line("sum of the parts", figureText(sumOfParts(budget, &Row::alone)),
                 figureText(sumOfParts(budget, &Row::removed)));
    text += line("all at once", figureText(budget.together), figureText(budget.total - budget.remaining));
    text += line("the frame", "", figureText(budget.total), "its error as it is");
    text += line("unexplained", "", figureText(budget.remaining), "its error with all of them taken out");
    text += line("noise of the reference", "", figureText(budget.noise), "in all of these");
    text += line("light between surfaces", figureText(budget.unmodelled), "", "in neither picture");
    return text;
}

} // namespace tarn
