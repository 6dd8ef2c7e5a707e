/* texts.h -- what is written as it is: the files of texts/, by texts.py. */
#pragma once

extern const char text_hdf5[], text_scene[], text_words[]; /* pages' heads */
extern const char text_gallery[];
extern const char text_bash[], text_zsh[], text_fish[];
