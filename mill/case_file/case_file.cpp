#include "mill/case_file/case_file.h"

#include "mill/base/text_file.h"
#include "mill/case/case_units.h"
#include "mill/case_file/case_build.h"
#include "mill/case_file/case_build_charge.h"
#include "mill/case_file/case_build_liner.h"
#include "mill/case_file/case_build_wear.h"
#include "mill/case_file/case_checks.h"
#include "mill/case_file/case_schema_check.h"
#include "mill/case_file/case_values.h"

namespace millwear {

Case read_case(const std::filesystem::path& file) {
  return case_from_text(read_text_file(file), file);
}

Case case_from_text(std::string_view text, const std::filesystem::path& file) {
  check_plain_text(text, file);
  const CaseDocument document = parse_case_document(text, file);
  CaseProblems problems(file);
  check_against_schema(document, problems);
  problems.throw_if_any();

  const CaseTable& mill = *document.find("mill");
  const CaseTable& lifter = *document.find("lifter");
  Case result{.name = text_value(*document.find(""), "name"),
              .file = file,
              .slice_length = real_value(mill, "slice_length_m"),
              .speed = 0.0,
              .feed_rate = {},
              .liner = build_liner(document, problems),
              .materials = build_materials(document, problems),
              .pairs = {},
              .liner_material = 0,
              .charge = {},
              .dem = build_dem(document),
              .wear = {},
              .campaign = build_campaign(document, problems),
              .gauge = build_gauge(document)};
  if (const auto feed = optional_real(mill, "feed_rate_t_per_h")) {
    result.feed_rate = feed_from_t_per_h(*feed);
  }
  result.pairs = build_pairs(document, result.materials, problems);
  result.liner_material = material_index(result.materials, lifter, "material",
                                         text_value(lifter, "material"), problems);
  result.wear = build_wear(document, result.materials, problems);
  result.charge = build_charge(document, result.materials, result.liner.sector, problems);
  problems.throw_if_any();

  result.speed = build_speed(document, result.liner.sector, largest_diameter(result), problems);
  check_case(result, document, problems);
  problems.throw_if_any();
  return result;
}

}  // namespace millwear
