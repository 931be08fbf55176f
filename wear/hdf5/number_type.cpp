#include "wear/hdf5/number_type.h"

#include <hdf5.h>

namespace millwear::wear {

std::int64_t in_memory(NumberType type) {
  switch (type) {
    case NumberType::real64:
      return H5T_NATIVE_DOUBLE;
    case NumberType::real32:
      return H5T_NATIVE_FLOAT;
    case NumberType::natural16:
      return H5T_NATIVE_UINT16;
    case NumberType::natural8:
      break;
  }
  return H5T_NATIVE_UINT8;
}

std::int64_t in_file(NumberType type) {
  switch (type) {
    case NumberType::real64:
      return H5T_IEEE_F64LE;
    case NumberType::real32:
      return H5T_IEEE_F32LE;
    case NumberType::natural16:
      return H5T_STD_U16LE;
    case NumberType::natural8:
      break;
  }
  return H5T_STD_U8LE;
}

}  // namespace millwear::wear
