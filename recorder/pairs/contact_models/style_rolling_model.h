// The rolling models that are compiled anew. LIGGGHTS reads this file several times: no guard.
#include <liggghts/rolling_model_cdt.h>
#include <liggghts/rolling_model_epsd2.h>
