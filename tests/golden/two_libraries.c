/* two_libraries A.so B.so: two versions of the library in one program, each with its own symbols. */
#include <dlfcn.h>
#include <pineda/golden.h>
#include <stdio.h>

typedef pineda_status (*open_call)(const char*, pineda_model**);
typedef void (*close_call)(pineda_model*);
typedef const char* (*error_call)(void);

int main(int argc, char** argv) {
  void* library[2];
  open_call open[2];
  close_call shut[2];
  error_call error[2];
  pineda_model* model[2] = {NULL, NULL};
  int i;
  if (argc != 3) return 2;
  for (i = 0; i < 2; ++i) {
    library[i] = dlopen(argv[1 + i], RTLD_NOW | RTLD_LOCAL);
    if (library[i] == NULL) {
      printf("%s\n", dlerror());
      return 1;
    }
    *(void**)&open[i] = dlsym(library[i], "pineda_open");
    *(void**)&shut[i] = dlsym(library[i], "pineda_close");
    *(void**)&error[i] = dlsym(library[i], "pineda_last_error");
  }
  if (open[0] == open[1]) return 1;
  for (i = 0; i < 2; ++i) {
    if (open[i]("high_tile", &model[i]) != PINEDA_OK) return 1;
  }
  /* What one was told the other does not know. */
  if (open[0]("no design", &model[0]) != PINEDA_NO_DESIGN) return 1;
  if (error[0]()[0] == '\0' || error[1]()[0] != '\0') return 1;
  for (i = 0; i < 2; ++i) {
    shut[i](model[i]);
    dlclose(library[i]);
  }
  return 0;
}
