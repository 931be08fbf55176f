// The normal models that are compiled anew. LIGGGHTS reads this file several times: no guard.
#include <liggghts/normal_model_hertz.h>
