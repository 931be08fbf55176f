// The normal models that this program compiles anew. LIGGGHTS reads this file several times over, so it
// has no guard.
#include <liggghts/normal_model_hertz.h>
