# cmake -D SCREENS=... -D GUIDE=... -P guide_pictures.cmake: the pictures of the guide, from those of `--screens`.
set(pictures
  build-carry tune/carry
  build-experts build/experts
  build-force build/force
  build-overview build/overview
  build-plan build/plan
  build-rules build/rules
  build-usability build/rules_usability
  build-word-intervals build/force_word_intervals
  build-words-and-rules build/experts_words_and_rules
  collect-home collect/home
  collect-monitor collect/monitor
  collect-protocol collect/protocol_refused
  collect-withdrawal collect/withdrawal
  labs-depth build/depth
  labs-speed-clusters build/speed
  labs-speed-strokes build/speed_strokes
  labs-speed-table build/speed_table
  nurse-force-answer-chosen take_part/force_answer_chosen
  nurse-force-off take_part/force_off
  nurse-own-model take_part/own_model
  nurse-question-neck take_part/question_neck
  nurse-review-neck take_part/review_neck
  nurse-speed take_part/speed
  nurse-thanks take_part/thanks
  nurse-welcome take_part/welcome
  path-collect collect/home_simulated
  path-deliver deliver/overview
  path-depth build/depth
  path-experts build/experts
  path-force build/force
  path-method build/method
  path-rules build/rules
  path-speed build/speed
  path-understand understand/overview
  bench-pull tune/pull
  feel-blind-duel feel/blind-duel
  feel-solid feel/solid
  simulator-mark understand/simulator
  tune-contracts tune/contracts_checked
  tune-strokes tune/strokes_after_edit
  tune-tell tune/tell)

set(made)
while(pictures)
  list(POP_FRONT pictures picture screen)
  file(COPY_FILE "${SCREENS}/${screen}.png" "${GUIDE}/${picture}.png")
  list(APPEND made "${picture}.png")
endwhile()
file(GLOB there RELATIVE "${GUIDE}" "${GUIDE}/*.png")
# One shows a report in a browser (chromium --headless --screenshot), one a screen of another procedure (--screens DIR --pack
# male-urethral-catheter, take_part/question_angle.png).
list(REMOVE_ITEM there ${made} living-report.png pack-question.png)
if(there)
  message(FATAL_ERROR "No screen is named for ${there}: add it to guide_pictures.cmake")
endif()
