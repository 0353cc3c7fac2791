/* Names of files are UTF-8 on Windows too: named MODEL copies the model to a folder and a file with such names and opens it. */
#include <direct.h>
#include <stdio.h>
#include <wchar.h>

#include <tactus/tactus.h>

int main(int argc, char **argv) {
  tactus_model *model = NULL;
  char message[256];
  int byte;
  FILE *in = argc == 2 ? fopen(argv[1], "rb") : NULL;
  FILE *out;
  _wmkdir(L"Gr\u00f6\u00dfe und Blank");
  out = _wfopen(L"Gr\u00f6\u00dfe und Blank\\Modell-\u00e4\u9f3b.tactus.json", L"wb");
  if (in == NULL || out == NULL) return 2;
  while ((byte = fgetc(in)) != EOF) fputc(byte, out);
  fclose(in);
  fclose(out);
  if (tactus_model_open("Gr\xc3\xb6\xc3\x9f" "e und Blank\\Modell-\xc3\xa4\xe9\xbc\xbb.tactus.json", &model, message, sizeof message) != TACTUS_OK) {
    puts(message);
    return 1;
  }
  printf("%u inputs\n", (unsigned)tactus_model_inputs(model));
  tactus_model_free(model);
  /* A folder, nothing, and a name that is no UTF-8: one sentence each. */
  return tactus_model_open(".", &model, NULL, 0) == TACTUS_BAD_FILE && tactus_model_open("none", &model, NULL, 0) == TACTUS_BAD_FILE &&
                 tactus_model_open("\xff", &model, NULL, 0) == TACTUS_BAD_FILE
             ? 0
             : 1;
}
