#pragma once
#include <charconv>
#include <string_view>
#include <system_error>

namespace millwear {

/// A printed line that is taken apart from its front. Once a part does not fit, none fits any more.
class LineParts {
 public:
  explicit LineParts(std::string_view line) : left_(line) {}

  LineParts& text(std::string_view expected) {
    fits_ = fits_ && left_.starts_with(expected);
    if (fits_) left_.remove_prefix(expected.size());
    return *this;
  }

  template <class Number>
  LineParts& number(Number& value) {
    const auto [end, problem] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
    fits_ = fits_ && problem == std::errc{};
    if (fits_) left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
    return *this;
  }

  /// A share that is printed in per cent.
  LineParts& percent(double& share) {
    number(share);
    share /= 100.0;
    return *this;
  }

  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] bool fits_to_the_end() const { return fits_ && left_.empty(); }
  [[nodiscard]] std::string_view left() const { return left_; }

 private:
  std::string_view left_;
  bool fits_ = true;
};

}  // namespace millwear
