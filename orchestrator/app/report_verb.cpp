#include "orchestrator/app/report_verb.h"

#include <CLI/CLI.hpp>

#include "mill/case_file/case_file.h"
#include "orchestrator/app/publication.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/run_lock.h"

namespace millwear::orchestrator {

void add_options(CLI::App& verb, ReportOptions& options) {
  add_options(verb, options.common);
  add_campaign_folder(verb, options.out);
  add_readings_folder(verb, options.readings);
}

void report_verb(const ReportOptions& options) {
  const Case mill = read_case(options.common.case_file);
  const RunFolder folder = run_folder_of(mill, options.out);
  const OpenCampaign opened = campaign_of(mill, folder);
  const RunLock lock(folder.lock());
  check_outputs(opened.ledger, folder.root);
  const CampaignResults data = publish_campaign(opened, options.readings);
  Progress progress(options.common.verbosity);
  publish_pictures_if_possible(folder, data, progress);
  print_outcome(options.common.form, folder, data);
}

}  // namespace millwear::orchestrator
