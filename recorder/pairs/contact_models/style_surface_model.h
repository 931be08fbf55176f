// The surface models that are compiled anew. LIGGGHTS reads this file several times: no guard.
#include <liggghts/surface_model_default.h>
