#include "orchestrator/app/report_verb.h"

#include <CLI/CLI.hpp>

#include "mill/case_file/case_file.h"
#include "orchestrator/app/publication.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/run_lock.h"
#include "orchestrator/drawing/drawn_liner_reader.h"

namespace millwear::orchestrator {

void add_options(CLI::App& verb, ReportOptions& options) {
  add_options(verb, options.common);
  add_campaign_folder(verb, options.out);
  add_readings_folder(verb, options.readings);
  verb.add_flag("!--no-pictures", options.pictures, "Draw no pictures");
  verb.add_option("--pictures-of", options.picture_cycles,
                  "Cycles of which all pictures of the charge are drawn, besides the first and the "
                  "last, such as 3,5")
      ->delimiter(',');
}

void report_verb(const ReportOptions& options) {
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  const RunFolder folder = run_folder_of(mill, options.out);
  const OpenCampaign opened = campaign_of(mill, folder);
  const RunLock lock(folder.lock());
  check_outputs(opened.ledger, folder.root);
  CampaignResults data = publish_campaign(opened, options.readings);
  if (options.pictures) publish_pictures(opened, options.picture_cycles, data);
  print_outcome(options.common.form, folder, data);
}

}  // namespace millwear::orchestrator
