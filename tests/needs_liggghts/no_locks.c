/* A file system without locks, as NFS without its lock daemon: flock fails with ENOLCK. */
#include <errno.h>

int flock(int file, int operation) {
  (void)file;
  (void)operation;
  errno = ENOLCK;
  return -1;
}
