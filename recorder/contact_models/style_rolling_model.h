// The rolling models that this program compiles anew. LIGGGHTS reads this file several times over, so it
// has no guard.
#include <liggghts/rolling_model_cdt.h>
#include <liggghts/rolling_model_epsd2.h>
