#include "orchestrator/app/column_pages.h"

#include <fmt/format.h>

#include <map>
#include <string_view>

#include "mill/base/contract.h"
#include "orchestrator/loads/spectra.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/landmarks.h"
#include "orchestrator/results/profiles.h"
#include "orchestrator/results/replicates.h"
#include "orchestrator/results/wear_rates.h"
#include "orchestrator/study/campaign_figures.h"

namespace millwear::orchestrator {
namespace {

constexpr std::string_view beginning = "<!-- columns of ";
constexpr std::string_view beginning_end = " -->\n";
constexpr std::string_view end = "<!-- end -->";

std::string figures_page() {
  std::string page = "| column | unit | what it is |\n|---|---|---|\n";
  for (const FigureColumn& column : figure_columns())
    page += fmt::format("| `{}` | {} | {} |\n", column.name, column.unit, column.doc);
  return page;
}

}  // namespace

std::string with_column_pages(const std::string& page) {
  const std::map<std::string, std::string> tables{
      {"history", columns_page(history_columns())},
      {"profiles", columns_page(profile_columns())},
      {"landmarks", columns_page(landmark_columns())},
      {"replicates", columns_page(replicate_columns())},
      {"spectra", columns_page(spectrum_columns())},
      {"study", figures_page()},
      {"wear rates", columns_page(wear_rate_columns())}};
  std::string made;
  std::size_t from = 0;
  for (std::size_t at; (at = page.find(beginning, from)) != std::string::npos;) {
    const std::size_t name = at + beginning.size();
    const std::size_t name_end = page.find(beginning_end, name);
    const auto table = tables.find(page.substr(name, name_end - name));
    expect(table != tables.end(), "the page names a table of columns that there is");
    const std::size_t table_begin = name_end + beginning_end.size();
    made += page.substr(from, table_begin - from) + table->second;
    from = page.find(end, table_begin);
    expect(from != std::string::npos, "a table of columns in the page has an end");
  }
  return made + page.substr(from);
}

}  // namespace millwear::orchestrator
