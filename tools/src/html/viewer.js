// Two of the pictures in one place, divided where the slider or the pointer is.
for (const viewer of document.querySelectorAll(".viewer")) {
  const pictures = viewer.nextElementSibling.querySelectorAll("img");
  const stage = viewer.querySelector(".stage");
  const range = viewer.querySelector("input");
  const show = (select) => {
    const image = stage.querySelector(`img[data-side=${select.dataset.side}]`);
    image.src = pictures[select.value].src;
    image.alt = pictures[select.value].alt;
  };
  const divide = () => stage.style.setProperty("--cut", `${range.value}%`);
  for (const select of viewer.querySelectorAll("select")) {
    select.addEventListener("change", () => show(select));
    show(select);
  }
  range.addEventListener("input", divide);
  const follow = (event) => {
    if (event.buttons === 1) {
      const place = stage.getBoundingClientRect();
      range.value = (100 * (event.clientX - place.left)) / place.width;
      divide();
    }
  };
  stage.addEventListener("pointerdown", follow);
  stage.addEventListener("pointermove", follow);
  divide();
  viewer.hidden = false;
}
