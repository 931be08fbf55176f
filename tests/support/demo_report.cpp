#include <filesystem>
#include <iostream>

#include "mill/base/published_file.h"
#include "orchestrator/pictures/plots.h"
#include "orchestrator/report/report.h"
#include "tests/support/synthetic_campaign.h"

/// Writes the report and the pictures of a made-up campaign into a folder, to look at while working
/// on their design: demo_report FOLDER
int main(int count, char** words) {
  namespace orchestrator = millwear::orchestrator;
  if (count != 2) {
    std::cerr << "usage: demo_report FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = words[1];
  const auto data = orchestrator::synthetic_campaign(9, 4);
  millwear::publish(folder / "report.html", orchestrator::report_html(data));
  orchestrator::write_plots(data, folder);
}
