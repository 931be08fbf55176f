#include "mill/case_file/case_file.h"

#include "mill/base/text_file.h"
#include "mill/case_file/case_build.h"
#include "mill/case_file/case_build_charge.h"
#include "mill/case_file/case_build_liner.h"
#include "mill/case_file/case_build_operation.h"
#include "mill/case_file/case_build_wear.h"
#include "mill/case_file/case_checks.h"
#include "mill/case_file/case_schema_check.h"
#include "mill/case_file/case_values.h"
#include "mill/case_keys/mill_keys.h"

namespace millwear {

Case read_case(const std::filesystem::path& file, const ReadDrawnLiner& draw) {
  return case_from_document(read_case_document(file), draw);
}

Case case_from_text(std::string_view text, const std::filesystem::path& file) {
  check_plain_text(text, file);
  return case_from_document(parse_case_document(text, file));
}

CaseDocument read_case_document(const std::filesystem::path& file) {
  return parse_case_document(read_text_file(file), file);
}

Case case_from_document(const CaseDocument& document, const ReadDrawnLiner& draw) {
  CaseProblems problems(document.file);
  check_against_schema(document, problems);
  problems.throw_if_any();

  const CaseTable& lifter = *document.find("lifter");
  Case result{};
  result.file = document.file;
  read_keys(top_keys(), document.find(""), result);
  read_keys(mill_keys(), document.find("mill"), result);
  read_keys(lifter_keys(), &lifter, result);
  result.liner = build_liner(document, result.liner.sector, draw, problems);
  result.materials = build_materials(document, problems);
  result.dem = build_dem(document);
  result.campaign = build_campaign(document, problems);
  result.gauge = build_gauge(document);
  result.pairs = build_pairs(document, result.materials, problems);
  result.liner_material = material_index(result.materials, lifter, "material",
                                         text_value(lifter, "material"), problems);
  result.wear = build_wear(document, result.materials, problems);
  result.charge =
      build_charge(document, result.materials, result.liner.sector, result.slice_length, problems);
  problems.throw_if_any();

  result.speed = build_speed(document, result, problems);
  result.campaign.operation = build_operation(document, result, problems);
  check_case(result, document, problems);
  problems.throw_if_any();
  return result;
}

}  // namespace millwear
