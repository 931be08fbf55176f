#include <fmt/format.h>

#include "mill/case_file/case_manual.h"

int main() { fmt::print("{}", millwear::case_file_manual()); }
